"""The problem file: overview, and a first example.

A problem file is YAML. Mappings (`name: value`) define names; lists make statements; a statement is one line of
mathematics. There is one way to say each thing. A file says, in this order of thought:

  what is read       title, text                              planar explain sections
  what is known      given (numbers), symbols (letters)       planar explain names
  the scene          points, surfaces, bodies                 planar explain points, planar explain bodies
  how it is joined   joints                                   planar explain joints
  what acts          loads (weight acts by itself)            planar explain loads
  how it moves       motion, instant or states                planar explain statements, planar explain motion
  at which instants  states                                   planar explain states
  what is asked      find, cases                              planar explain finds, planar explain quantities,
                                                              planar explain spans, planar explain oscillations,
                                                              planar explain paths, planar explain cases
  what a key says    answers                                  planar explain answers

An example, with a case in which something else is unknown:

    title: Spool pulled along a rough floor
    plane: vertical
    given: {m: 50 kg, k_G: 0.2 m, R: 0.45 m, r: 0.3 m, P: 100 N}
    points: {C: [0, 0], G: [0, R], T: [0, R + r]}
    surfaces: {floor: {through: C, angle: 0 deg}}
    bodies: {spool: {disk: G, radius: R, hub: r, mass: m, radius_of_gyration: k_G}}
    joints:
      - rolling: {between: [spool, floor], at: C}
    loads:
      - force: {body: spool, wound_at: T, magnitude: P, angle: 0 deg}
    instant: [at rest]
    find: {alpha: alpha(spool), friction: friction(C).x}
    cases:
      no_friction:
        unknowns: {k_G: m}
        instant: [friction(C).x = 0]
        find: {k_critical: k_G}
    answers: {alpha: 6.186 rad/s^2 cw, friction: 39.18 N, k_critical: 0.3674 m}

x points right, y up; angles and rotations are counterclockwise from +x. `planar explain examples` has more files, and
`planar explain pitfalls` the mistakes that are made most. `planar validate FILE` tells what is wrong with a file.
"""
