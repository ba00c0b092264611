"""Bodies: a shape, and what is known of the mass.

Each body has one shape:

    particle: P                    at the point P; it may have the point's name: P: {particle: P, mass: m}
    particle: [0, 2 m]             at coordinates; the body's name is that of its point too
    particle: free                 its place follows from the relations
    rod: [A, B]                    uniform and slender; theta is the direction from A to B
    rod: [A, 30 deg]               from A in that direction; `length:` where a place is open
    disk: G, radius: R             `hub: r` is a second, concentric step
    ring: G, radius: R             all mass at the rim
    sphere: G, radius: R
    disk: G                        no radius where nothing touches it and its inertia is told
    disk: O, radius: R, center: G  a wheel, ring or sphere whose mass centre G is not its middle O
    sector: O, radius: R, span: 180 deg, angle: 90 deg        its apex, opening angle, and the direction of its axis
    plate: G, width: b, height: h, angle: 0 deg               a rectangle about G; angle is that of its width
    points: [A, B], center: G      any other shape: its points, and its mass centre
    parts: [{…}, {…}]              composite: each part has a shape and a mass, minus for a hole

Then what is known of the mass:

    nothing                        massless
    mass: 5 kg                     or weight: 100 N; it may vary, `mass: M - q*t` or `rho*y(b)`, and the inertia with it
    mass: any                      not given; it must cancel
    inertia: 2 kg*m^2              about the mass centre, instead of that of the uniform body; any: it must cancel
    radius_of_gyration: 0.2 m      the same; either may be taken about another point: about: A
    points: [A, B]                 further points that belong to the body

Examples

    bodies:
      crank: {rod: [O, A], mass: 2 kg}
      spool: {disk: G, radius: R, hub: r, mass: m, radius_of_gyration: k_G}
      flywheel: {disk: O, radius: R, center: G, mass: m, radius_of_gyration: k_G}
      gate: {points: [A, B], center: G, weight: 600 N, inertia: 40 kg*m^2, about: A}
      wheel: {parts: [{disk: O, radius: 0.3 m, mass: 10 kg}, {particle: P, mass: 2 kg}]}
      plate: {parts: [{plate: G, width: b, height: h, mass: 9 kg}, {disk: H, radius: r, mass: -1 kg}]}

Where weight may act, `plane` is required: not for places, kinematics and moments of inertia. A body without mass
moves only as joints, motion and states say.
"""
