"""Oscillations: equilibrium, stability, small oscillations, and damped motion.

Equilibrium
  A state that says `equilibrium` is a position in which everything that is free can stay at rest: free speeds and their
  rates vanish. It stands apart from the order of the other states. What else it says chooses the position, if there are
  several: `[equilibrium, theta > 0]`, `[equilibrium, x = 0]`. Relative equilibrium, on something that turns at a
  constant rate under `motion`, is said in the same way. Other states may speak of it, `[at rest, s = s @ hang + d]`,
  wherever it is listed; listed first, it is the one that is drawn. One that is struck (`just after hang`) begins the
  motion.

      states: {hang: [equilibrium, s > 0]}
      find: {s_rest: s @ hang, holds: stable(hang), T: period(hang), f: frequency(hang) in Hz}

Small oscillations about it
  The equation of motion is linearised there, and its linear part printed.

  stable(s)            is a small deviation drawn back? true or false
  period(s)            2*pi/omega_d, of the damped oscillation if there is damping
  frequency(s)         its inverse: 1/s or Hz; the circular frequency with `in rad/s`
  decrement(s)         logarithmic decrement: ln of the ratio of two amplitudes a period apart, c*T/(2*m) of a block;
                       of the n-th after it divide by n: `decrement(s) = log(x_0/x_n)/n`
  damping_ratio(s)     damping as a part of the critical one, c/(2*m*omega_0); also where nothing oscillates

  What is told of them may determine constants under `unknowns`: `[equilibrium, theta = 0, period(hang) = 2 s]`, or
  `period(hang) is smallest`; `frequency(hang) = 0` is critical damping. A record of an oscillation that dies away
  tells stiffness and damping: `[equilibrium, x = 0, period(rest) = T, decrement(rest) = log(x_1/x_2)]`.

  Springs that join at a particle without mass, a knot on a `guide` along a fixed line, balance there all the time: that
  makes one stiffness of them. A damper at such a knot, or a motion from state to state, needs a mass there.

  With several freedoms each mode has its period: `T: period(hang)` is answered by all of them, the longest first, and
  `frequency(hang)` by all frequencies, the lowest first, `decrement(hang)` and `damping_ratio(hang)` in the same order;
  a key says `T: [1.23 s, 0.45 s]`. Inside a formula, or stated, a period has to be the only one. In letters there are
  formulas for two modes without damping, or with dampers that share them as the springs do. A rotation that enters
  no force has no mode; nor, where `stable(…)` is not asked, has a travel that enters none. Where the motion creeps
  back without oscillation, or the equilibrium is unstable, that is said instead (PL632). Dry friction has no small
  oscillations.

The whole motion
  The equation of motion is a find without an instant: `ddot(x)`. A motion from given initial conditions is one over
  time, with states (planar explain states): where it turns (`v(b).x = 0`), where it passes (`x = 0`), and whether it
  does (`reached(cross)`). Linear equations with constant coefficients are solved exactly: under-damped, critically
  damped or over-damped, free or driven by a force that is a polynomial, exponential or sinusoidal function of time. Of
  a pendulum that swings far the speeds are exact (v dv = a ds), and the times are numbers.

Steady vibration
  What a periodic force or a shaken support keeps up is what is left when the start has died away: ask for it at
  t = infinity. `crest: [t = infinity, x is largest]`; the amplitude is x @ crest, less its place of rest, and what is
  passed on to the support `(tension(s) + tension(d)) @ push` with `push: [t = infinity, tension(s) + tension(d) is
  largest]`. The start may be any, as `[t = 0, at rest, x = 0]`; everything must have a number. Without damping nothing
  dies away (PL724). The support that is shaken is a body too: `bodies: {base: {particle: B}}` at a point B
  that is written with a coordinate, and `motion: [y = b*sin(w*t)]`. Under `motion` x = X*sin(w*t) would not follow
  from the forces: it would add one of its own.

    title: Block between a spring and a damper
    plane: horizontal
    given: {m: 2 kg, k: 200 N/m, c: 8 N*s/m, x_0: 100 mm}
    coordinates: {x: m}
    points: {W: [-0.5 m, 0], P: [x, 0]}
    bodies: {block: {particle: P, mass: m}}
    joints:
      - guide: {point: P, along: 0 deg, name: rail}
    loads:
      - spring: {between: [W, P], stiffness: k, relaxed_at: [x = 0]}
      - damper: {between: [W, P], coefficient: c}
    find: {law: ddot(x)}
    cases:
      small:
        states: {rest: [equilibrium, x = 0]}
        find: {holds: stable(rest), T: period(rest), f: frequency(rest) in Hz, omega_d: frequency(rest) in rad/s}
      let_go:
        states:
          1: [t = 0, x = x_0, at rest]
          cross: [x = 0]
          turn: [v(block).x = 0]
        find: {crosses: reached(cross), t_cross: t @ cross, x_turn: x @ turn in mm}
    answers: {holds: true, T: 0.641275 s, omega_d: 9.79796 rad/s, crosses: true, t_cross: 0.18087 s, x_turn: -52.66 mm}
"""
