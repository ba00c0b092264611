"""Coordinates: positions that vary, and with which points are written.

    coordinates: {theta: deg, x: m}
    points:
      A: [0, 0]
      B: {from: A, distance: l, angle: theta}           goes round A
      G: [x, R]                                         moves along y = R

Such a point lies where its coordinates say in every position, not only as drawn. Where they are at one instant, a
relation says (`instant: [theta = 30 deg]`, `1: [x = 0, at rest]`), or what holds all the time: `motion: [dot(x) = u]`.
`theta` alone is the coordinate, `dot(theta)` and `ddot(theta)` are its rates. A find without `@` may be a formula in
it. A coordinate is not needed where a position as drawn is enough.

A rolling wheel
  Write its centre with the coordinate; the joint `rolling` tells how far the wheel has turned, R φ = x, so that its
  angle needs no coordinate. The point at which it touches goes along with the centre: leave out `at`, or write the
  point with the same coordinate, `C: [x, 0]` below `G: [x, R]`, on a slope `C: {from: G, distance: R, angle: -90 deg -
  beta}`. A point of the rim that is marked, and turns with the wheel, is another one:
  `P: {from: G, distance: R, angle: 90 deg - x/R}`.

    title: Wheel drawn back by a spring
    plane: vertical
    given: {m: 2 kg, R: 0.3 m, k: 50 N/m, x_0: 0.2 m}
    coordinates: {x: m}
    points: {Q: [0, 0], G: [x, R], C: [x, 0], W: [-1 m, R]}
    surfaces: {floor: {through: Q, angle: 0 deg}}
    bodies: {wheel: {disk: G, radius: R, mass: m}}
    joints:
      - rolling: {between: [wheel, floor], at: C}
    loads:
      - spring: {between: [W, G], stiffness: k, natural_length: 1 m}
    states: {1: [x = x_0, at rest], 2: [x = 0]}
    find:
      v: v(G).x @ 2
      omega: omega(wheel) @ 2
      turned: theta(wheel) @ 2 - theta(wheel) @ 1 in deg
    answers: {v: -0.816497 m/s, omega: 2.72166 rad/s ccw, turned: 38.1972 deg}
"""
