"""Points and surfaces.

Points are given as drawn: at the instant, or at the first state (with `coordinates`: always).

    points:
      A: [0, 0.2 m]                                     coordinates x, y
      B: {from: A, distance: l, angle: 30 deg}
      C: {from: A, towards: B, distance: l}             `offset: h` besides: h to the left of the line from A to B
      D: {midpoint: [A, B]}
      E: {x: 0.3 m, distances: {A: l}}                  two facts out of:
                                                          x: 1 m
                                                          y: 2 m
                                                          line: [A, 30 deg]         on the line through A
                                                          lines: [[A, 30 deg], [B, 120 deg]]   where two lines cross
                                                          distances: {A: l, B: d}   from points (one or two facts)
      F: {distances: {A: l, B: d}, side: above}         where two places fit, `side` says which:
                                                          left, right, above, below (the other one)

A point of no body is fixed, unless it is written with a coordinate, as the centre of a wheel that rolls and the point
at which it touches: planar explain coordinates. A point that is named with a body in a joint or load belongs to that
body; a point at which several bodies are pinned together is the particle's, if one of them is a particle, else it is
that of the first of them. Sizes of points use names, not quantities and not the time.

`line` may also be written `{through: A, angle: 30 deg}`, and as `on` (`line` and `on` together: two lines);
`{from: A, distance: l, on: [B, 0 deg]}` is the point of the line at this distance.

A place may also be written where it is used: `at: [1 m, 0]`, `rod: [[0, 0], {from: A, distance: l, angle: 30 deg}]`.
Where the same is written twice, it is the same point.

Surfaces

    surfaces:
      floor: {through: P, angle: 0 deg}                 a straight line
      drum: {center: O, radius: R}                      a circle; bodies are inside or outside as drawn, a
                                                        particle on the side on which it presses: one that must be
                                                        outside lies on a disk that is welded to the ground
      bowl: {y: c*x^2}                                  a curve, x is its variable
      spiral: {r: b*theta}                              a curve in polar coordinates, theta is its variable
      top: {through: Q, angle: 0 deg, body: cart}       fixed to a moving body
      conveyor: {through: C, angle: 0 deg, speed: u}    a belt whose surface runs along its angle with the speed u
"""
