"""Examples: whole problem files, beside that of `planar explain language`.

A motion over time, and how far it goes:

    title: Hanging rod set swinging
    plane: vertical
    points: {A: [0, 0], B: [0, -2 m]}
    bodies: {rod: {rod: [A, B], mass: 12 kg}}
    joints:
      - pin: {at: A, between: [ground, rod]}
    states:
      1: [t = 0, omega(rod) = 2.8125 rad/s]
      2: [omega(rod) = 0]
    find: {phi_max: theta(rod) @ 2 - theta(rod) @ 1 in deg, t_2: t @ 2, pull: reaction(A).mag @ 1}

Does it slip, and when would it:

    title: Ladder that may slip
    plane: vertical
    given: {m: 20 kg, l: 4 m, mu: 0.35}
    coordinates: {beta: deg}
    points: {A: [0, 0], B: {from: A, distance: l, angle: beta}}
    surfaces: {floor: {through: A, angle: 0 deg}, wall: {through: B, angle: 90 deg}}
    bodies: {ladder: {rod: [A, B], mass: m}}
    joints:
      - contact: {between: [ladder, floor], at: A, mu: mu}
      - contact: {between: [ladder, wall], at: B, mu: 0}
    cases:
      leaning:
        instant: [beta = 60 deg, at rest]
        find: {stays: mode(A) = stick, foot: friction(A).x}
      flattest:
        instant: [at rest, mode(A) = stick, beta is smallest, beta > 0]
        find: {beta_min: beta in deg}
    answers: {stays: true, beta_min: 55.01 deg}

Motion of a projectile, without a mass:

    title: Projectile onto a falling slope
    plane: vertical
    bodies: {P: {particle: [0, 0], mass: any}}
    states:
      launch: [t = 0, v(P).mag = 10 m/s, v(P).angle = 45 deg]
      B: [y(P) = -3/4*x(P)]
    find: {d: r(P).mag @ B, t_B: t @ B, v_B: v(P) @ B in km/h}

Kinematics, no masses at all:

    title: Slider and crank
    points: {O: [0, 0], A: {from: O, distance: 0.1 m, angle: 60 deg}, B: {y: 0, distances: {A: 0.3 m}, side: right}}
    bodies: {crank: {rod: [O, A]}, rod: {rod: [A, B]}}
    joints:
      - pin: {at: O, between: [ground, crank]}
      - pin: {at: A, between: [crank, rod]}
      - guide: {point: B, along: 0 deg}
    motion: [omega(crank) = 20 rad/s cw]
    find: {v_B: v(B).x, a_B: a(B).x, omega_rod: omega(rod)}
"""
