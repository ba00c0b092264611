"""States: the instants of a motion, in their order.

    states:
      launch: [t = 0, v(P).mag = 10 m/s, v(P).angle = 45 deg]
      top: [y(P) is largest]
      land: [y(P) = 0]
      later: [t = 3 s]

Each state has a name and a list of relations that hold then; a quantity in it without `@` is at that state.

Order
  States stand in the order in which they happen. The first one starts the motion: time is counted from it unless it
  says `t = …`, and points are drawn there (a relation that contradicts the drawing is an error). Every other state is
  the *first* instant after the one before it at which its relations hold, so that `land` above is not the launch
  itself, and `y(P) = 2 m` after `top` is on the way down. A state with a given time, `t = 3 s`, may stand anywhere.
  Inequalities choose among positions and roots: `[x(P) = 4 m, y(P) > 0]`.
  `[mode(C) = slip]` alone is the first instant at which it is so.

What starts a motion
  `at rest`: whatever `motion` does not drive has no velocity; `P at rest` says it of one body. What is not stated of
  the first state may follow from later ones: a target, a duration. A constant is sought when it stands under
  `unknowns`.
  Released at rest in an unstable equilibrium nothing moves, and `reached(s)` says so. Where a later state asks for
  more, or a find without `@` asks for a speed as a formula, the motion is the limit of a slight touch, as the check
  says: speeds and forces are told, no times. Friction that redundant contacts share holds as long as some share does.

Largest and smallest
  `X is largest` uses up one freedom. In a state that nothing else dates, it is the time: the instant at which X is
  largest; of a motion in which it grows from one maximum to the next, the first. In a state that something else dates
  (`y(P) = 0`, or a given time), it is a constant under `unknowns`: the one with which X there is largest. In the first
  state a mode or an inequality bounds it, `start: [at rest, mode(C) = stick, mu is smallest]`: the start is told
  first, as an instant of its own, and what is found there is given to the motion.

Where what acts changes
  Places and velocities are the same before and after it. Accelerations, forces and modes may jump; at a state they are
  those just after it: of a block that has just come to rest on a slope, `mode(A) @ top` says whether it stays, and
  `a(block) @ top` is its acceleration downwards, or zero. What a state itself states, such as `N(C) = 0`, is read as
  the body arrives; so is the force of a joint that ends there: after `during: 1->2`, `N(C) @ 2` is the last one.

Infinity
  `t = infinity` is where the motion tends: a terminal velocity, a place of rest. A speed is printed there that is never
  quite reached; `[v(P).mag = 0.95*v_end]` and the like are ordinary states. `[t = infinity, x is largest]` is a crest
  of the vibration that is left in the end: planar explain oscillations.

States that do not happen
  A state that is never reached is an error (PL621), unless `reached(s)` asks about it: then the answer is true or
  false.

Each state complete in itself
  A file that says nothing of time may list several positions, each with its own velocities. These are solved apart.
  `equilibrium` states stand apart too: planar explain oscillations.

Just after
  `just after 1` is at the same place and time as state 1; an impact, an impulse, or a joint that takes hold has changed
  the velocities: planar explain blows.

Time, a turning point, and a place that is reached too late or never:

    title: Block sent up a slope
    plane: vertical
    given: {v_0: 6 m/s, beta: 30 deg, mu: 0.2}
    points: {A: [0, 0]}
    surfaces: {slope: {through: A, angle: beta}}
    bodies: {block: {particle: A, mass: any}}
    joints:
      - contact: {between: [block, slope], at: A, mu: mu}
    states:
      start: [t = 0, v(block).along(beta) = v_0]
      top: [v(block).mag = 0]
      back: [y(block) = 0]
      far: [r(block).mag = 10 m, y(block) > 0]
    find:
      t_top: t @ top
      d: r(block).mag @ top
      stays: mode(A) @ top = stick
      t_back: t @ back
      v_back: v(block).mag @ back
      gets_there: reached(far)
    answers: {t_top: 0.90851 s, d: 2.72553 m, stays: false, t_back: 2.21252 s, v_back: 4.18025 m/s, gets_there: false}

The largest of two kinds: over the time at `top`, over the sought angle at `land`:

    title: Longest throw from a tower
    plane: vertical
    given: {h: 20 m, v_0: 15 m/s}
    unknowns: {alpha: deg}
    bodies: {stone: {particle: [0, h], mass: any}}
    states:
      throw: [t = 0, v(stone).mag = v_0, v(stone).angle = alpha]
      top: [y(stone) is largest]
      land: [y(stone) = 0, x(stone) is largest]
    find: {angle: alpha in deg, y_top: y(stone) @ top, x_max: x(stone) @ land}
    answers: {angle: 31.1186 deg, y_top: 23.0631 m, x_max: 37.9932 m}
"""
