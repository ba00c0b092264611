"""The grammar of statements: what is accepted, what is refused with which repair, and hostile text."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import (
    AtRest,
    Binary,
    Equilibrium,
    Extreme,
    Function,
    Grouped,
    JustAfter,
    Name,
    Negate,
    Number,
    PointPair,
    Quantity,
    Relation,
    Scaled,
    Side,
    Word,
)
from planar_cli.problem.language.parser import (
    ParseError,
    parse_found,
    parse_law,
    parse_magnitude,
    parse_side,
    parse_span,
    parse_statement,
)
from planar_cli.problem.language.words import is_reserved

HERE = Mark("f", 7, 11)


def written(node: Side | Relation | PointPair) -> str:
    """The tree with all brackets, for comparison."""
    match node:
        case Number(value=value, unit=unit, sense=sense):
            return f"{value}" + (f"[{unit}]" if unit else "") + ("cw" if sense < 0 else "")
        case Name(name=name, at=at):
            return name + (f"@{at}" if at else "")
        case Word(word=word):
            return word
        case PointPair(to=to, origin=origin):
            return f"{to}/{origin}"
        case Quantity():
            return quantity(node)
        case Binary() | Relation():
            return pair(node)
        case _:
            return wrapped(node)


def pair(node: Binary | Relation) -> str:
    left, right = written(node.left), written(node.right)
    return f"({left}{node.operator}{right})" if isinstance(node, Binary) else f"{left} {node.operator} {right}"


def wrapped(node: Negate | Scaled | Function | Grouped) -> str:
    match node:
        case Negate(operand=operand):
            return f"-{written(operand)}"
        case Scaled(operand=operand, unit=unit, sense=sense):
            return f"{written(operand)}[{unit}]" + ("cw" if sense < 0 else "")
        case Function(name=name, argument=argument, at=at):
            return f"{name}({written(argument)})" + (f"@{at}" if at else "")
        case Grouped(operand=operand, at=at):
            return f"{{{written(operand)}}}@{at}"


def quantity(side: Quantity) -> str:
    inside = "/".join(side.things) if side.argument is None else written(side.argument)
    parts = "".join(f".{p.kind}" + (f"({written(p.direction)})" if p.direction else "") for p in side.parts)
    at = side.at if isinstance(side.at, str) or side.at is None else "->".join(side.at)
    return f"{side.word}({inside}){parts}" + (f"@{at}" if at else "")


@pytest.mark.parametrize(
    ("text", "tree"),
    [
        ("0.45", "9/20"),
        ("010", "10"),
        ("1e-3 m", "1/1000[m]"),
        (".5", "1/2"),
        ("5.", "5"),
        ("2 N*m", "2[N*m]"),
        ("-2 N*m", "-2[N*m]"),
        ("(2 N*m) + M", "(2[N*m]+M)"),
        ("(pi/4) rad/s", "(pi/4)[rad/s]"),
        ("4 m/s^2 + 0.3 m/s^3 * t", "(4[m/s^2]+(3/10[m/s^3]*t))"),
        ("1000 N * 0.03 s", "(1000[N]*3/100[s])"),
        ("x^2/(2 m)", "((x^2)/2[m])"),
        ("2 kg/(m*s)", "2[kg/(m*s)]"),
        ("5 1/s", "5[1/s]"),
        ("4 in", "4[in]"),
        ("2*3 m", "(2*3[m])"),
        ("6.186 rad/s^2 cw", "3093/500[rad/s^2]cw"),
        ("5 rad/s ccw", "5[rad/s]"),
        ("c*v(b).mag^2", "(c*(v(b).mag^2))"),
        ("-3/4*x(P)", "-((3/4)*x(P))"),
        ("-x^2 + 1", "(-(x^2)+1)"),
        ("a - b - c", "((a-b)-c)"),
        ("a/b*c", "((a/b)*c)"),
        ("x^-2", "(x^-2)"),
        ("x^n*2", "((x^n)*2)"),
        ("x^(1/2)", "(x^(1/2))"),
        ("sqrt(2*g*h)", "sqrt(((2*g)*h))"),
        ("sin(30 deg) @ 2", "sin(30[deg])@2"),
        ("(x - y) @ top", "{(x-y)}@top"),
        ("t @ B", "t@B"),
        ("no_friction.k_critical", "no_friction.k_critical"),
        ("theta(rod) @ 3 - theta(rod) @ 1", "(theta(rod)@3-theta(rod)@1)"),
        ("KE(P) @ 2/KE(P) @ 1", "(KE(P)@2/KE(P)@1)"),
        ("v(B/A).along(30 deg) @ 2", "v(B/A).along(30[deg])@2"),
        ("r(P).along(B/A)", "r(P).along(B/A)"),
        ("v(P).across(rod)", "v(P).across(rod)"),
        ("v(D/AB).r", "v(D/AB).r"),
        ("work(all) @ 1->2", "work(all)@1->2"),
        ("impulse(A).x @ 1 -> 2", "impulse(A).x@1->2"),
        ("dot(theta)", "dot(theta)"),
        ("ddot(r(P).mag)", "ddot(r(P).mag)"),
        ("count(v(P).x = 0) @ 1->2", "count(v(P).x = 0)@1->2"),
        ("mean(F) @ 1->2", "mean(F)@1->2"),
        ("reached(2)", "reached(2)"),
        ("period(top)", "period(top)"),
        ("M - q*t", "(M-(q*t))"),
        ("r*v*N*I*m", "((((r*v)*N)*I)*m)"),
        ("infinity", "infinity"),
    ],
)
def test_sides(text: str, tree: str) -> None:
    assert written(parse_side(text, HERE)) == tree
    assert parse_magnitude(text, HERE) == parse_side(text, HERE)


def test_marks_are_exact() -> None:
    side = parse_side("  a + 2*v(B).along(x/l) ", HERE)
    assert isinstance(side, Binary)
    assert side.mark.column == 11 + 4
    assert side.left.mark.column == 11 + 2
    product = side.right
    assert isinstance(product, Binary)
    assert isinstance(product.right, Quantity)
    assert product.right.mark == Mark("f", 7, 11 + 8)
    assert product.right.parts[0].mark.column == 11 + 13


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("at rest", AtRest),
        ("rod at rest", AtRest),
        ("equilibrium", Equilibrium),
        ("just after 1", JustAfter),
        ("y(P) is largest", Extreme),
        ("beta is smallest", Extreme),
        ("mode(C) = stick", Relation),
        ("0 < a", Relation),
        ("M <= 2 N*m cw", Relation),
        ("v(P).angle = 45 deg", Relation),
        ("y(P) = -3/4*x(P)", Relation),
    ],
)
def test_statements(text: str, kind: type) -> None:
    statement = parse_statement(text, HERE)
    assert isinstance(statement, kind)
    assert statement.text == text
    assert statement.mark == HERE
    assert parse_law(text, HERE).statement == statement


def test_statement_details() -> None:
    rest = parse_statement("rod at rest", HERE)
    assert isinstance(rest, AtRest)
    assert rest.body == "rod"
    extreme = parse_statement("y(P) is smallest", HERE)
    assert isinstance(extreme, Extreme)
    assert extreme.sense == -1
    law = parse_law("v(P).x = 3 m/s during 1->top", HERE)
    assert law.during == ("1", "top")
    assert law.statement.text == "v(P).x = 3 m/s"
    assert parse_span("a -> 2", HERE) == ("a", "2")


@pytest.mark.parametrize(
    ("text", "what", "unit"),
    [
        ("v(P) @ B in km/h", "v(P)@B", "km/h"),
        ("d @ 2 in ft/s", "d@2", "ft/s"),
        ("x(P) in in", "x(P)", "in"),
        ("(a - b) in in", "(a-b)", "in"),
        ("3 in", "3[in]", None),
        ("5 in in cm", "5[in]", "cm"),
        ("v(P).x/2 in km/h", "(v(P).x/2)", "km/h"),
        ("x^2 in m^2", "(x^2)", "m^2"),
        ("mode(A) = stick", "mode(A) = stick", None),
        ("path(P)", "path(P)", None),
        ("mu", "mu", None),
    ],
)
def test_finds(text: str, what: str, unit: str | None) -> None:
    found = parse_found(text, HERE)
    assert (written(found.what), found.unit, found.text) == (what, unit, text)


def table(rows: str) -> list[tuple[str, str, int, str]]:
    """Text ('' where it is empty), code, column (from 1), words of the hint."""
    found = []
    for row in rows.strip().splitlines():
        text, code, column, hint = map(str.strip, row.split("|"))
        found.append((text.replace("\\n", "\n").replace("''", ""), code, int(column), hint))
    return found


REFUSED = table(
    r"""
2 m*g             | PL204 |  3 | `2*m*g`
10 m/s^3*t        | PL204 |  4 | `(10 m/s^3)*t`
pi/6 rad          | PL204 |  6 | `(pi/6) rad`
1/2 m             | PL204 |  5 | `(1/2) m`
x^2/2 m           | PL204 |  7 | `x^2/(2 m)`
3 kg*9.81         | PL204 |  3 | `3 kg * 9.81`
2 N*m + M         | PL204 |  3 | `(2 N*m)`
1000 N*s/m * x    | PL204 |  6 | `(1000 N*s/m)`
5 N*sin(2)        | PL204 |  3 | `5 N * sin(…)`
2 g*h             | PL204 |  3 | `2*g*h`
500 N/g           | PL204 |  5 | kg
0.08 1/(m*s)^0.5  | PL204 |  6 | `1/(m^(1/2)*s^(1/2))`
2 l               | PL203 |  3 | `2*l`
3 sec             | PL203 |  3 | `s`
2 m/sec^2         | PL203 |  3 | `s`
3 t               | PL203 |  3 | tonne
5 N-m             | PL203 |  3 | `N*m`
2 lbs             | PL203 |  3 | `lbf`
2m                | PL205 |  1 | `2 m`
2 sin(3)          | PL205 |  3 | `2*sin(…)`
l m               | PL205 |  3 | `l*m`
x^2 m             | PL205 |  5 | `(x^2) m`
a b               | PL205 |  3 | `a*b`
(a)(b)            | PL205 |  4 | `(a)*(…)`
5 cw              | PL205 |  3 | `5 rad/s cw`
0x1F              | PL206 |  1 |
1_000             | PL206 |  1 | `1000`
2024-01-02        | PL206 |  1 |
1.2.3             | PL206 |  1 |
inf               | PL206 |  1 | infinity
nan               | PL206 |  1 |
.inf              | PL213 |  1 | finite
12:30             | PL202 |  3 | 90 s
30°               | PL202 |  3 | deg
2·x               | PL202 |  2 | `*`
π                 | PL202 |  1 | `pi`
θ                 | PL202 |  1 | `theta`
5 %               | PL202 |  3 | fraction
'a'               | PL202 |  1 |
a\nb              | PL202 |  2 | one line
distance(A, B)    | PL208 |  1 | `r(B/A).mag`
foo(3)            | PL208 |  1 | `foo*(…)`
omga(b)           | PL208 |  1 | `omega(…)`
atan2(y, x)       | PL208 |  1 | atan(y/x)
v (A)             | PL208 |  3 | `v(`
sin 3             | PL208 |  1 | `sin(…)`
v(2*A)            | PL208 |  3 | `v(B/A)`
r(B - A)          | PL208 |  5 | `r(B/A)`
v(A/B/C)          | PL208 |  1 |
I(rod, O)         | PL209 |  6 | `I(rod/O)`
sin(a, b)         | PL209 |  6 |
(a, b)            | PL209 |  3 |
a, b              | PL209 |  2 |
a = b             | PL210 |  3 |
(a = b)           | PL210 |  4 |
true              | PL211 |  1 |
off               | PL211 |  1 |
ground            | PL211 |  1 |
d in km           | PL211 |  3 | number
v(P) @            | PL212 |  7 | `@ 2`
v(P) @ 1->        | PL212 | 11 | 1->2
v(P) @ ->2        | PL212 |  8 | 1->2
x @ 1->2          | PL212 |  9 | mean
3 m @ 2           | PL212 |  5 |
v(P).magnitude    | PL213 |  6 | `.mag`
v(P).along        | PL213 | 11 | .along(30 deg)
(r(A) - r(B)).mag | PL213 | 14 | r(B/A).mag
a.b.c             | PL213 |  4 | case.find
x.y(3)            | PL213 |  2 |
F.along(3)        | PL213 |  2 | v(F).x
--x               | PL214 |  2 | brackets
a - -b            | PL214 |  5 | brackets
2*-3              | PL214 |  3 | brackets
+x                | PL214 |  1 |
(1                | PL214 |  1 | `)`
1)                | PL214 |  2 |
()                | PL214 |  2 |
x**2              | PL215 |  2 | `^`
2^3^4             | PL215 |  4 | (b^c)
x^13              | PL215 |  2 |
x^(1/7)           | PL215 |  2 |
x^-(1/2)          | PL215 |  4 | `^(-…)`
1/0               | PL216 |  2 |
1/(2 - 2)         | PL216 |  2 |
0^-1              | PL216 |  2 |
''                | PL201 |  1 |
a +               | PL201 |  4 |
* a               | PL201 |  1 |
"""
)
REFUSED_STATEMENTS = table(
    """
a == b              | PL210 |  3 | `=`
a => b              | PL210 |  3 | `>=`
a != b              | PL210 |  3 |
0 < a < 3           | PL210 |  7 | `0 < a` and `a < 3`
a                   | PL210 |  1 | `a = …`
v(P)                | PL210 |  1 | left = right
x is big            | PL211 |  6 | largest
just 1              | PL211 |  6 | just after
P at                | PL211 |  5 | at rest
true at rest        | PL211 |  1 |
just after          | PL212 | 11 |
x = 1 m during 1->2 | PL211 |  9 |
a = 2 m in km       | PL211 |  9 | number
"""
)


@pytest.mark.parametrize(
    ("parse", "text", "code", "column", "hint"),
    [*((parse_side, *row) for row in REFUSED), *((parse_statement, *row) for row in REFUSED_STATEMENTS)],
)
def test_refused(parse: Callable[[str, Mark], object], text: str, code: str, column: int, hint: str) -> None:
    with pytest.raises(ParseError) as error:
        parse(text, Mark("f", 1, 1))
    diagnostic = error.value.diagnostic
    assert (diagnostic.code, diagnostic.mark.column) == (code, column)
    assert hint in diagnostic.hint


@pytest.mark.parametrize("text", ["x in Nm", "x in", "x in foo", "x in m, y", "x in m @ 2"])
def test_refused_units_of_finds(text: str) -> None:
    with pytest.raises(ParseError) as error:
        parse_found(text, HERE)
    assert error.value.diagnostic.code == "PL203"


@pytest.mark.parametrize("text", ["1", "1->", "->2", "1-2", "1->2->3", "1.5->2"])
def test_refused_spans(text: str) -> None:
    with pytest.raises(ParseError):
        parse_span(text, HERE)


def test_reserved_names() -> None:
    assert all(map(is_reserved, ("t", "pi", "on", "No", "all", "ground", "stick", "sin", "is", "in", "cw")))
    assert not any(map(is_reserved, ("r", "v", "N", "theta", "g", "e", "rod", "x", "mag", "rest")))
