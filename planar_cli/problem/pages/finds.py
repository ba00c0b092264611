"""Finds: what is asked.

`find` gives names to what is asked: a quantity, an expression, or a relation (is it true?), with `in unit` if wanted.

    find: {a: a(G).mag, share: KE(disk)/KE(all), slips: mode(C) = slip, v: v(B).mag @ 2 in km/h}

- In a file with `instant` a find is at that instant.
- In a file with `states` it says `@`, or is constant, or is a formula that holds throughout.
- With neither it is a formula in `t` (if the file uses t) and the `coordinates`; if there is none of these, the value
  in the drawn position. So `ddot(theta)` is the equation of motion.
- A path or hodograph is a curve, whatever the instant or state of the other finds: planar explain paths.
- Its unit is the one after `in`, else that of `answers`, else SI (US customary when all of `given` is; where `given`
  has no units, when all of the file is).
"""
