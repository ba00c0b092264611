"""Spans: quantities between two states.

`@ 1->2` behind a quantity takes it from state 1 to the later state 2.

  path_length(P)       distance run: to and fro both count (the displacement is x(P) @ 2 - x(P) @ 1)
  mean(…)              mean over the time: mean(v(P).x), mean(power(motor)). The mean velocity is mean(v(P))
  count(…)             how often a relation happens: count(theta(b) = 0). Touching counts, the beginning does not
  work(f)              of a load, of a joint, of a body (all forces on it) or `all`; on the body named
  impulse(f)           the same, a vector: impulse(f).x. Of a joint on body b: impulse(j/b). About P: impulse(f/P)
  heat(j)              energy that friction at the joint j takes; not negative

  Over a blow (`2: [just after 1]`) `work` and `impulse` are those of the impulses, `heat` what is lost.

  They are integrals over time. One is written as a difference where the integrand is the rate of a function of places
  and time (a constant force, a spring, a weight); else the law of motion is put in; else it is integrated along with
  the motion, in numbers. A path length is the sum of its parts between the instants at which the velocity vanishes.

In a state's own relations a span needs a closed form: `[work(brake) @ 1->2 = -500 J]` dates state 2, or determines an
unknown. Between the two states the motion may then not turn round; put a state where it does. Where everything has a
number, the way gone alone, `[path_length(P) @ 1->2 = 12 m]`, is also looked for step by step, on any curve.

    title: Crate pushed along a floor and let go
    plane: vertical
    given: {m: 20 kg, mu: 0.3, F: 100 N}
    points: {C: [0, 0]}
    surfaces: {floor: {through: C, angle: 0 deg}}
    bodies: {crate: {particle: C, mass: m}}
    joints:
      - contact: {between: [crate, floor], at: C, mu: mu}
    loads:
      - force: {body: crate, magnitude: F, angle: 0 deg, name: push, during: start->free}
    states:
      start: [t = 0, at rest]
      free: [t = 2 s]
      stop: [v(crate).x = 0]
    find:
      d: path_length(crate) @ start->stop
      W: work(push) @ start->free
      Q: heat(C) @ start->stop
      S: impulse(push).x @ start->free
      v_mean: mean(v(crate).x) @ start->stop
    answers: {d: 6.98947 m, W: 411.4 J, Q: 411.4 J, S: 200 N*s, v_mean: 2.057 m/s}

A count:

    title: Flywheel running down
    given: {r: 0.3 m}
    points: {O: [0, 0], P: [r, 0]}
    bodies: {wheel: {disk: O, radius: r, points: [P]}}
    joints:
      - pin: {at: O, between: [ground, wheel]}
    motion: [alpha(wheel) = -0.2 1/s * omega(wheel)]
    states:
      1: [t = 0, omega(wheel) = 40 rad/s]
      2: [t = 5 s]
    find: {way: path_length(P) @ 1->2, passes: count(y(P) = r) @ 1->2}
    answers: {way: 37.9272 m, passes: 20}
"""
