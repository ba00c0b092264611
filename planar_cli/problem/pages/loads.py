"""Loads: what acts on bodies.

Weight acts by itself when `plane: vertical`; it is never written. `loads` is a list of entries, each one kind with
its keys. Any entry may have `name:` and `during: 1->2`.

    loads:
      - force: {body: b, at: A, magnitude: 50 N, angle: 30 deg}    a particle needs no `at`; `wound_at: T` instead
                                                                   for a cord that unwinds from the rim point T.
                                                                   The direction: angle; or towards: P; or angle with
                                                                   relative_to: b (turns with b)
      - torque: {body: b, moment: 40 N*m}                          or between: [a, b]: on b, reversed on a
      - spring: {between: [A, B], stiffness: 200 N/m, natural_length: 0.3 m}
                                                                   or relaxed_at: [theta = 0]; acts: push or pull
      - damper: {between: [A, B], coefficient: 20 N*s/m}
      - drag: {body: b, magnitude: c*v(b).mag^2}                   always against the velocity
      - impulse: {body: b, at: S, magnitude: 30 N*s, angle: 0 deg, during: 1->2}
                                                                   or moment: 3 N*m*s
      - stream:                                                    angles fixed in space, speeds relative to the body
          body: b
          rate: 4 kg/s
          enters: {at: A, speed: 15 m/s, angle: 0 deg}
          leaves: {at: B, speed: 15 m/s, angle: 90 deg}

`body` may be left out where one alone can be meant: the only body, the one to which the point belongs, for a torque the
only one that turns. `drag: {quadratic: c}` is c v^2 and `drag: {linear: c}` is c v.

Magnitudes of force, torque and drag, and the rate of a stream, may use `t`, quantities, and tables of instants and
values (straight lines between them, constant before the first and after the last); speeds and angles of a stream may
use `t` and quantities:

    magnitude: 10 N/s * t
    magnitude: {table: [[0 s, 0 N], [2 s, 50 N]]}

What keeps a motion going that `motion` prescribes need not be written. A load of unknown size that acts along it is
taken for it, also on a body without mass: with `unknowns: {S: N}` and `a(A).x = 3 m/s^2` under `motion`, the S of
`force: {body: slider, magnitude: S, angle: 0 deg}` is the force that this takes, and nothing else drives. So S = 0
where nothing resists.

A mass may vary too, `mass: M - q*t` or `mass: rho*y(end)`, and its moment of inertia with it: see `planar explain
stream`. `planar explain force` (torque, spring, …) prints the page of each, and `planar explain motion` says how
motions under loads that vary are integrated.
"""
