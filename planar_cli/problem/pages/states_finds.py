"""States and finds: several instants, and what is asked.

    states:
      launch: [t = 0, v(P).mag = 10 m/s, v(P).angle = 45 deg]
      top: [y(P) is largest]
      ground_again: [y(P) = 0]
    find: {d: x(P) @ ground_again, t_top: t @ top, v: v(P) @ ground_again in km/h, W: work(all) @ launch->top}

- States stand in the order in which they happen. A state fixed by `t = …` may stand anywhere; every other one is the
  first instant after the one before it at which its relations hold. Inequalities choose among positions and roots:
  y(C) > 0.
- In a state, a quantity without `@` is at that state.
- `just after 1`: same place and time as state 1; velocities change by impulses only.
- `X is largest` (or smallest) uses up whatever freedom is left, time or an unknown: `top: [y(P) is largest]`,
  `[F is largest, mode(C) = stick]`.
- `at rest`: all that `motion` does not drive.
- Points are drawn at the first state; a relation that contradicts the drawing is an error.
- A state that is never reached is an answer too: `reached(2)`.
- Loads and joints with `during: 1->2` act between these states only.

Finds

  `find` gives names to what is asked: a quantity, an expression, or a relation (is it true?), with `in unit` if wanted.

    find: {a: a(G).mag, share: KE(disk)/KE(all), slips: mode(C) = slip, v: v(B).mag in km/h}

- In a file with `instant` a find is at that instant.
- In a file with `states` it says `@`, or is constant, or is a formula that holds throughout.
- With neither it is a formula in `t` (if the file uses t) and the `coordinates`; if there is none of these, the value
  in the drawn position.
- Its unit is the one after `in`, else that of `answers`, else SI (US customary when all of `given` is).
"""
