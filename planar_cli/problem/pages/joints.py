"""Joints: how bodies are held.

`joints` is a list of entries, each one kind with its keys. `between: [a, b]` takes bodies, surfaces, `ground`. Any
entry may have `name:` (else it is called by its point, else by its first body) and `during: 1->2` (acts only between
these states; a joint that starts with moving parts starts with an impulse).

    joints:
      - pin: {at: A, between: [ground, AB]}                    two bodies or more; friction_torque: 2 N*m
      - weld: {at: A, between: [AB, plate]}
      - guide: {point: B, along: 0 deg}                        or `body: b` (then it cannot turn); along an angle, a
                                                               surface or a body (its slot); mu, or mu_s and mu_k, else
                                                               smooth
      - link: {between: [A, C]}                                a light rigid rod between two points; length
      - rolling: {between: [wheel, floor], at: C}              no slip: wheels, racks, gears, inside a ring
      - belt: {between: [small, large]}                        two disks; crossed: true
      - contact: {between: [block, floor], at: C, mu: 0.3}     `mu` (0 is smooth), or `mu_s` and `mu_k`, or
                                                               `friction: 25 N`, a fixed limit
      - flat: {between: [block, table], mu: 0.3}               a body lying on another in a horizontal plane; friction
                                                               as at a contact
      - rope: {path: [A, over D, under E, T on drum]}          one rope, one tension. A point in the middle is a small
                                                               pulley; `T on drum`: wound, leaving at T; `along: 90 deg`
                                                               (all parts parallel): pulley sizes are left out
      - impact: {between: [A, B], restitution: 0.8, during: 1->2}    normal: an angle, if the shapes leave it open;
                                                               restitution left out: unknown; mu

`at` may be left out of `contact` and `rolling` where the shapes tell it: a particle, a wheel on an edge or another rim,
a plate with a face on an edge. `between: [wheel, ground]` is a horizontal floor below the wheel, the particle, the
upright plate or the point `at`, unless `plane: horizontal`; anything else that is touched is a surface. `mu_k` alone:
it slides; `mu_s` alone: whether it slides, and what does not depend on the kinetic coefficient.

A contact always says its friction. When the surface is rough and no coefficient is given, write `unknowns: {mu: 1}` and
`mu: mu`. `planar explain pin` (guide, rope, …) prints the page of each.
"""
