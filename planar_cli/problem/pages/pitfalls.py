"""Pitfalls: what goes wrong most, and what to write.

on, off, yes, no            no key or name is spelt so; answers say true or false
a: > 0                      relations are whole strings in a list: `- a > 0`
distance(A, B)              no comma stands inside a quantity: r(B/A).mag, I(rod/O); YAML would split it
P: ?                        what is asked for is declared: `unknowns: {P: N}`, then `find: {P: P}`
1e-3, 010, 1_000, 12:30     numbers are decimal: 0.001, 10, 1000; no times, no underscores, no 0x
note: Rod: hinged           words with `: ` or ` #` go below `>-`
k: 3 # N                    a unit in a comment is lost: `k: 3 N`
instant: {omega(CD): 3}     a list: `instant: [omega(CD) = 3 rad/s]`
a == 3, 0 < a < 3           one relation sign in each string: `a = 3`, and two entries
v_A, omega_AB               a quantity has a bracket: v(A), omega(AB)
AB for the vector           r(B/A): place of B seen from A
2 m*g                       the unit ends the number: 2*m*g; (pi/6) rad; x/(2 m)
N m, kg.m^2                 N*m, kg*m^2
x**2                        x^2
lb in a force               `lb` is a mass; the force is `lbf`
omega = 5                   in `motion` constant, in `instant` only now
several roots               the first instant after the state before; inequalities choose: `y(C) > 0`
a state on the way back     a state of its own before it: `top: [y(P) is largest]`, then `[y(P) = 2 m]`
X is largest, twice over    without another date it dates the state; beside `y(P) = 0` it fixes an unknown
displacement, distance      x(P) @ 2 - x(P) @ 1, and path_length(P) @ 1->2
KE(P) @ 2/KE(P) @ 1         `@` belongs to what stands just before it, so this is a ratio of two values
a find without @            in a file with states only what is constant, or a formula that holds throughout
force on whom               on the body whose partner is the ground; between two moving bodies reaction(B/AB)
sign of friction            it is a vector on the body named: ask .x or .along(30 deg)
sign along a slope          .along(direction); there is no hidden "positive up the slope"
.t, .n at zero speed        undefined; on a circle use .across
370 deg or 10 deg           theta(b) and r(P).angle count turns; other angles lie in (-180, 180]
a body without mass         is massless; `mass: any` where it must cancel
plane forgotten             required where weight or a motion with mass matters
a contact without mu        say it: `mu: 0` is smooth
at: C, on: floor            `between: [spool, floor], at: C`
a rope over a heavy pulley  one rope has one tension: two ropes wound on the pulley when it does not slip
pulleys of no given size    `along: 90 deg`
a banked road, a conical    a section across the way: `at rest`, a body that carries the road or the hook with
pendulum                    `a(road).x = -v^2/rho` towards the centre, and `a(bob).y = 0` on a single cord
a cord that unwinds         `wound_at: T`; with `at: T` the force stays with the body's point
a force for a short time    `impulse` with `just after` when nothing moves meanwhile, else `force` with `during`
smallest coefficient,       `mu is smallest` with `mode(C) = stick`
just about to slip
an unknown in given         `given` has values, `symbols` stays letters, `unknowns` is solved for; a case may move it
rough, but no coefficient   `unknowns: {mu: 1}` and `mu: mu`; then a datum is missing, and the solution says which
a case that removes         not possible: put what differs into the cases
"""
