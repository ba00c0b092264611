"""Motion over time: laws, forces that vary, and how they are integrated.

Kinematics alone, with laws under `motion`:

    motion:
      - x(P) = 4 m * sin(3 rad/s * t)                place as a function of time
      - v(P).x = (20 m^2/s)/(x(P) + 4 m)             velocity as a function of place
      - a(P).x = 2 m/s^2 - 0.5 m/s^3 * t             a(t)
      - a(P).x = -4 1/s^2 * x(P)                     a(x)
      - a(P).x = -0.2 1/m * v(P).x^2                 a(v)
      - alpha(b) = -0.3 1/s * omega(b)               rotation alike; `dot(s)`, `ddot(s)` of a coordinate s
      - a(P).x = 0 during cruise->brake              in this span only

Or kinetics: bodies with mass, and loads whose magnitude uses `t`, places, velocities, or a table (straight lines
between its rows). Loads and joints with `during: 1->2` act in that span only; so a motion has phases.

    - force: {body: b, magnitude: 20 N - 4 N/s * t, angle: 0 deg}
    - force: {body: b, magnitude: {table: [[0 s, 0 N], [2 s, 50 N], [6 s, 0 N]]}, angle: 0 deg}
    - drag: {body: b, magnitude: c*v(b).mag^2}

`states` say where the motion starts and what instants are asked about: planar explain states.

What happens then
  The equations of motion are set up once, in a general position. Each span between two states is integrated by the
  relation that connects what is known with what is asked:

      dx = v dt     dv = a dt     v dv = a dx     dt = dv/a(v)     dx = v dv/a(v)     dt = dx/v(x)

  and the same for an angle, an arc length or any other coordinate. Drag with c*v^2 is linear in v^2; a linear equation
  with constant coefficients goes by its characteristic equation, with a particular solution for what drives it. Every
  limit of integration is printed. A root that is not the one that happens is told with the reason.

  Numbers are used when no closed form is known: an equation between states that no formula solves, an integral without
  an antiderivative, or coupled nonlinear equations of motion, which are integrated step by step (Dormand and Prince's
  method of order 8). The solution says that it went this way.

Contacts and ropes
  Where a body comes to rest, turns round, or a contact opens, the assumption about it (stick, slip, apart; taut, slack)
  is examined anew, and the next span has its own equations of motion. Nobody has to announce that in the file.

Masses are needed only where they do not cancel: `mass: any`.

Laws in three phases:

    title: Car between two traffic lights
    bodies: {car: {particle: [0, 0]}}
    joints:
      - guide: {point: car, along: 0 deg, name: road}
    motion:
      - a(car).x = 2 m/s^2 during start->cruise
      - a(car).x = 0 during cruise->brake
      - a(car).x = -2.5 m/s^2 during brake->stop
    states:
      start: [t = 0, at rest]
      cruise: [v(car).x = 90 km/h]
      brake: [t = 60 s]
      stop: [v(car).x = 0]
    find: {t_90: t @ cruise, d: x(car) @ stop, v_mean: mean(v(car).x) @ start->stop in km/h}
    answers: {t_90: 12.5 s, d: 1468.75 m, v_mean: 75.5357 km/h}

A force that depends on the velocity:

    title: Stone that sinks in oil
    plane: vertical
    given: {m: 0.2 kg, c: 1.5 N*s/m, h: 0.5 m}
    bodies: {stone: {particle: [0, 0], mass: m}}
    loads:
      - drag: {body: stone, magnitude: c*v(stone).mag}
    states:
      top: [t = 0, at rest]
      soon: [t = 0.2 s]
      bottom: [y(stone) = -h]
      end: [t = infinity]
    find: {v_soon: v(stone).mag @ soon, t_bottom: t @ bottom, v_end: v(stone).mag @ end}
    answers: {v_soon: 1.01614 m/s, t_bottom: 0.512703 s, v_end: 1.308 m/s}
"""
