"""Statements: motion, instant, and the grammar of one line.

`motion` holds relations that are true all the time, so they may be differentiated: `omega(OB) = 2 rad/s` means that
the rate is constant. With `during 1->2` behind it a relation holds in that span only. `instant` holds relations that
are true at the one instant asked about: there `omega(OB) = 2 rad/s` says nothing about the acceleration. `assume`
holds relations between names. Laws of motion over time: planar explain motion.

    motion: [omega(OB) = 2 rad/s, a(P).x = 3 m/s^2 during 1->2]
    instant: [beta = 60 deg, at rest]
    assume: [a < g]

`at rest` means: all that `motion` does not drive has no velocity. `B at rest` says it of one body. `equilibrium`: at
rest, and without acceleration. Each statement is a whole string in a list, with exactly one of = < > <= >= in it; `0
< a < 3` is two statements.

Nothing that is written is ignored. A relation between known numbers is checked. An inequality rejects modes and roots
that make it false; where a speed stays open it tells its direction, and so which way friction acts:
`instant: [v(crate).x > 0]`. Names of `given` and `symbols` that nothing uses, and masses that drop out, are listed as
`Not used`; where a mode rests on letters the page says on which side they lie (`Assume μ cos β > sin β`), and
`assume: [mu < tan(beta)]` takes the other.

    relation  = side ("=" | "<" | ">" | "<=" | ">=") side | side "is" ("largest" | "smallest")
              | [name] "at rest" | "equilibrium" | "just after" state
    law       = relation ["during" span]                               in motion
    found     = (side | relation) ["in" unit]                          in find
    side      = ["-"] term {("+" | "-") term}           term = power {("*" | "/") power}
    power     = atom ["^" (["-"] number | name | "(" side ")")]
    atom      = number [" " unit ["cw" | "ccw"]] | "(" side ")" [" " unit] [at] | name ["." name] [at] | "t" [at]
              | "pi" | "infinity" | function "(" side ")" [at] | quantity
              | "stick" | "slip" | "apart" | "tip" | "taut" | "slack"
    quantity  = word "(" argument ")" {"." part} [at]   at   = "@" (state | span)      span = state "->" state
    argument  = thing ["/" thing] | side (in dot, ddot, mean) | relation (in count) | state (in reached, period …)
    part      = "x" | "y" | "mag" | "angle" | "t" | "n" | "r" | "theta" | ("along" | "across") "(" direction ")"
    direction = side | body | point "/" point

`planar explain quantities` says what the quantities mean.
"""
