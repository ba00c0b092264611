"""Methods: Newton, d'Alembert, Lagrange, energy, momentum, and which of them is taken.

At one instant accelerations and forces follow from Newton's law (or d'Alembert's form of it, or from Lagrange's
equations: `method: lagrange`). Between two states there are three laws, and all of them are written side by side:

  newton     the law of motion is found from forces, and integrated: v dv = a ds, dv = a dt
  energy     T_1 + U_1-2 = T_2: places and speeds, no time and no acceleration
  momentum   m v_1 + ∫F dt = m v_2, H_1 + ∫M dt = H_2: times and speeds; conserved where nothing acts

The plan takes the cheapest way to what is asked: energy where a speed belongs to a place, momentum where a force grows
with time or nothing acts, Newton's law where a time, an acceleration or a reaction is asked. Two states may need a
chain: an impact, then energy, then Newton's law for a reaction. Whatever is chosen, the motion is also followed step by
step from Newton's law, and the digits that agree are printed (planar explain checks).

    method: energy

names the principle that is used, and no other; so does `--method energy`. It is an error if it does not reach what is
asked (PL570), as Lagrange's equations do not reach reactions that do no work. Blows are told by impulse and momentum
in every method. `planar solve --compare` lists how many equations each method takes and what it reaches.

States that no motion joins
  With `method: energy` two states are related even if the motion from the first would not lead to the second by
  itself, as some textbook problems have it; that is said beside the answer. Without it such a state is an error.

    title: Disk down a slope
    plane: vertical
    given: {m: 4 kg, R: 0.2 m, beta: 25 deg, s: 3 m}
    points: {C: [0, 0], G: {from: C, distance: R, angle: 90 deg - beta}}
    surfaces: {slope: {through: C, angle: -beta}}
    bodies: {disk: {disk: G, radius: R, mass: m}}
    joints:
      - rolling: {between: [disk, slope], at: C}
    states:
      1: [t = 0, at rest]
      2: [r(G).along(-beta) = s]
    method: energy
    find: {v: v(G).along(-beta) @ 2}
    answers: {v: 4.07229 m/s}
"""
