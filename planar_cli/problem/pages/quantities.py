"""Quantities: what can be stated and asked.

A quantity is a word with a bracket at once behind it. `b` is a body (its mass centre where a point is meant), `P` a
point or body, `j` a joint, `f` a load, `all` the whole system. A stroke joins two things; no comma stands anywhere.

  x(P) y(P) r(P) v(P) a(P)      place and motion; `v(B/A)` seen from a frame that moves with point A and does not turn;
                                `v(P/b)` seen from body b. The distance from A to B is r(B/A).mag
  theta(b) omega(b) alpha(b)    angle and its rates; `omega(b/c)` relative
  dot(…) ddot(…)                rate of anything, and its rate: dot(theta), ddot(r(P).mag)
  coriolis(P/b)                 Coriolis acceleration of P against b
  rho(P) IC(b)                  radius of curvature; instantaneous centre
  path(P) path(P/A) path(P/b)   the curve that P describes: over the ground; seen from a frame that moves with A and
                                does not turn, A its origin; seen from body b, its origin at the mass centre (of a rod,
                                at its first point) and its x axis along theta(b)
  hodograph(P)                  the curve of the tip of its velocity; its axes are v_x and v_y
                                Both hold throughout, whatever the instant or state of the other finds: planar
                                explain paths
  N(j) friction(j) reaction(j)  at joint j, on the body whose partner is the ground; else `reaction(j/b)`: on b.
  moment(j) tension(j)          N, moment and tension are numbers, the others vectors
  force(f)                      the force of a load
  mode(j)                       stick, slip, apart or tip of a contact; taut or slack of a rope (does it slip?)
  mass(b) I(b) I(b/P)           mass; moment of inertia about the mass centre, or about P
  KE(b) PE(b) momentum(b)       kinetic and potential energy, linear momentum; PE is that of the weight,
                                `PE(all)` has the springs as well
  H(b/P)                        angular momentum about P
  power(f)                      of a load

  with a span, @ 1->2 (planar explain spans):
  work(f) impulse(f)            of a load, joint, body (all forces on it) or `all`; impulse(f/P): angular, about P
  heat(j)                       energy that friction takes
  path_length(P)                distance run
  mean(…) count(…)              mean of a quantity; how often a relation happens: count(theta(b) = 0)

  of a state, in files with `states` (planar explain states, planar explain oscillations):
  reached(s)                    does the state occur?
  period(s) frequency(s)        of small oscillations about an equilibrium state; of several modes a list, slowest first
  decrement(s) damping_ratio(s) logarithmic decrement, and damping as a part of the critical one, likewise
  stable(s)                     is that equilibrium stable?

Parts of vectors
  .x .y .mag .angle             v(P).x
  .along(direction)             along(30 deg), along(b) (the direction of body b), along(B/A): from A to B
  .across(direction)            90 deg counterclockwise of it
  .t .n                         along the velocity, and towards the centre of curvature (v and a; not at zero speed)
  .r .theta                     along and across r of the same bracket: v(P/O).r is seen from O

At an instant
  `@ 2` or `@ top` after a quantity, name or bracket: its value at that state; `@ 1->2`: over a span. It belongs to what
  stands just before it: v(P) @ 2 - v(P) @ 1.
"""
