"""Paths and hodographs: the curves of a motion, and its natural and polar components.

  path(P)              the curve over the ground
  path(P/A)            seen from a frame that moves with point A and does not turn; A is its origin
  path(P/b)            seen from body b: origin at its mass centre (of a rod, at its first point), x axis along theta(b)
  hodograph(P)         the curve of the tip of the velocity, drawn from one point; its axes are v_x and v_y
  rho(P)               radius of curvature of the path

  A curve is told with its name (straight line, circle, ellipse, parabola, hyperbola, cycloid, spiral, …) and its
  equation, from which the parameter is eliminated step by step; where that can not be done, by its parametric
  equations. Everything must depend on one thing: the time, or one coordinate (else PL650). A curve holds throughout,
  whatever the instant or state of the other finds. In `answers` it is an equation in x and y, in vx and vy (of a
  hodograph), or in r and theta.

Components
  v(P).t a(P).t a(P).n         along the velocity, and towards the centre of curvature: a.n = v^2/rho. Where the speed
                               is zero they mean nothing; on a circle use .across(P/O).
                               A law `a(P).t = …` from rest goes the positive way along a guide, or as the first
                               state says: `a(P).y < 0`
                               A free particle of which these and rho(P) alone are told needs no direction:
                               `instant: [v(P).mag = 15 m/s, a(P).t = 3 m/s^2, rho(P) = 50 m]`
  r(P).mag v(P).r v(P).theta   polar, along r and 90 deg counterclockwise of it: a.r = ddot(r) - r*dot(theta)^2
  v(P/A).r, a(P/O).theta       the same from A or O instead of the origin

A file without states asks for formulas:

    title: Bead on a turning rod
    symbols: {c: m/s, w: rad/s, l: m}
    points: {O: [0, 0], A: {from: O, distance: l, angle: 0 deg}, P: [0, 0]}
    bodies: {rod: {rod: [O, A]}, bead: {particle: P}}
    joints:
      - pin: {at: O, between: [ground, rod]}
      - guide: {point: P, along: rod}
    motion: [theta(rod) = w*t, v(P/rod).along(A/O) = c]
    find: {curve: path(P), in_rod: path(P/rod), speeds: hodograph(A), radius: rho(P)}
    answers: {curve: r = c*theta/w, in_rod: y = 0, speeds: x^2 + y^2 = l^2*w^2}

A coordinate instead of the time:

    title: Point of a sliding rod
    given: {l: 2 m, b: 0.5 m}
    coordinates: {phi: deg}
    points:
      A: [l*cos(phi), 0]
      B: [0, l*sin(phi)]
      P: {from: A, towards: B, distance: b}
    bodies: {rod: {rod: [A, B], points: [P]}}
    joints:
      - guide: {point: A, along: 0 deg}
      - guide: {point: B, along: 90 deg}
    find: {curve: path(P), circle: path(B/A)}
    cases:
      moving:
        motion: [dot(phi) = 2 rad/s]
        instant: [phi = 30 deg]
        find: {radius: rho(P), a_n: a(P).n, a_t: a(P).t}
    answers:
      curve: x^2/(l - b)^2 + y^2/b^2 = 1
      circle: x^2 + y^2 = l^2
      radius: 0.866025 m
      a_n: 3.4641 m/s^2
      a_t: 4 m/s^2
"""
