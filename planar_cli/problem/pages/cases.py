"""Cases: the same scene with changes.

A case holds any of the keys from `title` to `find`. Lists (joints, loads, motion, instant, assume) are added to, names
(given, points, bodies, states …) replaced; a `given` name may become an unknown or a symbol. Nothing can be taken away:
put what differs into the cases. Only a case with an `instant` of its own has it in place of the file's `states`, and
one with `states` of its own has them in place of the file's `instant`.

    cases:
      no_friction:
        unknowns: {k_G: m}
        instant: [friction(C).x = 0]
        find: {k_critical: k_G}
      heavier:
        given: {m: 80 kg, k_G: no_friction.k_critical}
        find: {alpha_heavier: alpha(spool)}

The file's own `find` is answered for the file as it stands, a case's for the file with its changes. A later case may
use an earlier case's find as `case.find`, also a formula, in letters that it has too. The finds of all cases stand side
by side, so their names differ. A file that asks nothing itself may be incomplete; then its cases complete it.
"""
