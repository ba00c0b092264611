"""What each diagnostic code of the reading layer means, for `planar explain PL203`."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_YAML = {
    "PL101": "The file cannot be read: it is missing, a folder, a link, a device, or not allowed to be read. Give "
    "the path of a regular file, or `-` for standard input.",
    "PL102": "The file passes a limit: 256 kB in all, 30 levels of nesting, 20 000 entries, 10 000 characters in "
    "one text. Put each problem into a file of its own.",
    "PL103": "The file is not UTF-8, or has a character that cannot be seen: a control character, a no-break "
    "space, a mark that reverses the direction of writing. Save as UTF-8 and delete the character at the "
    "place that is shown.",
    "PL104": "The text is not YAML at this place: a bracket or quote is not closed, a comma is missing, or a line "
    "is not indented like its neighbours. Example: `points: {A: [0, 0], B: [1 m, 0]}`.",
    "PL105": "Anchors `&a`, references `*a`, tags `!x`, `%` directives and merge keys `<<` are not part of the "
    "language. Write the value again, or give it a name: `given: {l: 2 m}`. A product needs both factors:"
    " `2*k`.",
    "PL106": "A file holds exactly one problem. It is empty, or a line `---` begins a second one.",
    "PL107": "A key or an entry of a list has no value; `~` and `null` count as no value. Write the value, or "
    "leave the key out. What is to be solved for stands under `unknowns:` with its unit: `unknowns: {F: "
    "N}`.",
    "PL108": "A comma inside a bracket ends an entry of a list, so that `[distance(A, B) = 3 m]` would be two "
    "strings. No quantity has a comma: write `r(B/A).mag = 3 m`, `I(rod/O)`.",
    "PL109": "A key stands twice in one mapping, and only one of the two could count. Delete one or rename it.",
    "PL110": "A key is one word before a colon: `mass: 3 kg`. Lists and mappings cannot be keys, and no key is empty.",
    "PL111": "No value begins with `?`, `@`, `%`, `*`, `&`, `!`, a backquote, or `>` with a number behind it. An "
    "unknown is declared under `unknowns:`; a relation is a whole string in a list, `- a >= 3`.",
    "PL112": "Lines are indented with spaces; a tab is not allowed there. Most editors can replace tabs by spaces.",
    "PL113": "A second `: ` in a line would begin a mapping inside a value. Put words with a colon on the next "
    "line, indented, after `>-`: `note: >-` and below it `Rod: hinged`.",
}

_EXPRESSIONS = {
    "PL201": "The expression is empty, ends too early, or has something that does not fit. Example: `3/4*l + "
    "r(B/A).mag`.",
    "PL202": "Only letters A to Z, digits, `_` and `+ - * / ^ ( ) . = < > @` stand in an expression. Greek letters"
    " are spelt out (`theta`), degrees are `deg`, squares are `^2`, per cent is a fraction.",
    "PL203": "The unit is not known. Units are put together from m, mm, cm, km, kg, g, tonne, s, ms, min, h, rad, "
    "deg, rev, rpm, Hz, N, kN, Pa, J, W, hp, in, ft, yd, mi, lb, lbf, slug, mph, kip, psi with `*`, `/` "
    "and `^`: `2 N*m`, `3 m/s^2`.",
    "PL204": "A unit could be read in two ways here. Behind `/`, or with a `*` inside a longer expression, number "
    "and unit stand in brackets: `x^2/(2 m)`, `(pi/6) rad`, `(2 N*m) + M`. A product of names is `2*m*g`.",
    "PL205": "Two things stand side by side without a sign. Multiplication is written `*`: `2*m*g`. A unit follows"
    " a number or bracket after a space: `2 m`, `(l/2) m`.",
    "PL206": "The number is not a plain decimal number such as `0.45`, `10` or `1e-3`. Dates, `0x1F`, `1_000`, "
    "`12:30`, `inf` and `nan` are none; at most 40 digits and an exponent of three.",
    "PL207": "The expression passes a limit: 2000 characters, 500 parts, brackets 60 deep, 2 powers on top of each"
    " other, a chain of more than 100 names, or a number that is too large or too small (beyond 10^50 or 10^-50 in m, "
    "kg, s), also one to which names lead by powers of powers. Give names to parts under `given:`.",
    "PL208": "A word with a bracket is a quantity or a function: `v(P)`, `sin(30 deg)`. The bracket follows at "
    "once, and holds names for a quantity: `v(B/A)` is the velocity of B seen from A.",
    "PL209": "No comma stands in an expression. Two names are joined by a stroke: `r(B/A).mag`, `I(rod/O)`. Two "
    "statements are two entries of the list.",
    "PL210": "A statement has exactly one of `=`, `<`, `>`, `<=`, `>=`. Write `0 < a < 3` as two entries, `0 < a` "
    "and `a < 3`.",
    "PL211": "A word of the language stands where it has no meaning. `in` belongs to `find`, `during` to `motion`,"
    " `at` to `at rest`, `is` to `is largest` and `is smallest`; `on`, `yes`, `true` and the like are no "
    "names.",
    "PL212": "`@` is followed by the name of a state, or by a span with both ends: `v(P) @ 2`, `work(f) @ 1->2`. "
    "It belongs to the quantity, name or bracket just before it.",
    "PL213": "Behind a quantity stand parts: `.x .y .mag .angle .t .n .r .theta .along(30 deg) .across(B/A)`. "
    "Numbers and names have none; `case.find` is the find of a case.",
    "PL214": "A sign or bracket is in the wrong place. A second sign stands in brackets, `2*(-3)`; every bracket "
    "is closed.",
    "PL215": "A power is written `x^2`, `x^-1`, `x^(1/2)`, `x^n`. A power of a power needs brackets; a numerical "
    "exponent is at most 12, with a denominator of at most 6.",
    "PL216": "The expression divides by a constant that is zero.",
    "PL217": "The formula has no real, finite value: the root or the logarithm of a negative number, `asin(2)`, `tan` "
    "of a right angle, or `infinity` as a number. A state may say `t = infinity`, or that a coordinate is infinite.",
    "PL220": "The terms of a sum have different dimensions, such as a force and a length. A bare number needs its "
    "unit: `4 m/s^2 + 0.3 m/s^3 * t`.",
    "PL221": "The two sides of a relation have different dimensions. Often a factor is missing, or a unit belongs "
    "to another quantity: `lb` is a mass, `lbf` a force.",
    "PL222": "Functions take an angle or a pure number: `sin(30 deg)`, `exp(x/l)`. A direction is an angle, a "
    "body, or two points.",
    "PL223": "An exponent is a pure number, and a constant one if the base has a unit: `x^2`, `(x/l)^n`.",
    "PL224": "The value has another dimension than the key or bracket needs. Example: `mass: 3 kg`, not `mass: 30 "
    "N`; a weight is given as `weight: 30 N`.",
    "PL225": "A number without a unit stands where one is due. Write `3 m`, `30 deg`; `# m` behind it is only a "
    "comment. Zero needs no unit.",
    "PL226": "A mode such as stick or slip, a curve, or a true-or-false answer is no number. Write `mode(C) = stick`.",
    "PL227": "The unit behind `in` does not fit what is asked for. Example: `v(P).mag @ 2 in km/h`.",
}

CODES: Mapping[str, str] = MappingProxyType({**_YAML, **_EXPRESSIONS})
