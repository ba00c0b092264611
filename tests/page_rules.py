"""The ten rules of a printed page, counted on the golden pages: what a lecturer would mark on them.

`page_of` reads a page of fixed width back into lines of one kind each, a wrapped equation as one; the rules below take
such a page and give the phrases that break them. The golden pages are what the program prints, which `test_problems`
holds, so nothing is solved here.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from conftest import ROOT

PAGES = tuple(sorted((ROOT / "tests" / "golden").glob("*.solution.txt")))
WIDTH = 110
LABELS = tuple("Given|Find|Principle|Effects|Not used|Assume|Fails|Instead|Answer|Check|Discussion".split("|"))
FUNCTIONS = frozenset(
    "sin cos tan cot sec csc arcsin arccos arctan atan2 sinh cosh tanh arsinh arcosh artanh".split()
    + "ln exp sign abs e π √ ∫".split()
)
NUMBER = r"-?\d+(?:\.\d+)?(?:×10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"
SYMBOL = re.compile(r"[^\W\d_][\u0300-\u036f\u20d7]?[\w\u0300-\u036f]*(?:[,/][A-Za-z]\w*)*′?")
SIDES = re.compile(r" (?:=|≤|≥|<|>|≈) ")


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a page, its wrapped rows joined.

    `kind`: title, heading, text, forces, equation, or the label of a note in small letters. `part`: how many cases
    stand before it. `number`: what an equation is called by. `lead`: what stands before its first side.
    """

    kind: str
    text: str
    part: int
    number: int | None = None
    lead: str = ""
    sides: tuple[str, ...] = ()

    @property
    def left(self) -> str:
        """The first side of an equation."""
        return self.sides[0] if self.sides else ""

    @property
    def is_datum(self) -> bool:
        """Does it only say what the file gives?"""
        return self.lead == "given:" or re.search(r" {3}given$", self.text) is not None

    @property
    def numeric(self) -> bool:
        """Is it an equation in numbers, with the unit in which it counts behind it?"""
        return re.search(r" {3}in \S+$", self.text) is not None


@dataclass(frozen=True, slots=True)
class Page:
    """A page: the name of its problem, its lines, and how many rows it fills."""

    name: str
    rows: tuple[Row, ...]
    length: int

    def of(self, *kinds: str) -> list[Row]:
        """The lines of some kinds."""
        return [r for r in self.rows if r.kind in kinds]

    @property
    def several(self) -> bool:
        """Does it tell of several states?"""
        return any(r.kind == "heading" and re.search(r"states? \w+, |^SPAN", r.text) for r in self.rows)


@cache
def page_of(path: Path) -> Page:
    """A golden page, read back."""
    rows = path.read_text(encoding="utf-8").splitlines()
    return Page(path.name.removesuffix(".solution.txt"), tuple(_rows(rows)), len(rows))


def _rows(lines: list[str]) -> Iterator[Row]:
    """The lines of a page, each with its wrapped rows."""
    part, gathered = 0, list[str]()
    label = ""
    for i, line in enumerate(lines):
        if not line.strip():
            yield from _body(gathered, part)
            gathered, label = [], ""
        elif i == 0:
            yield Row("title", line, 0)
        elif not line.startswith(" "):
            yield from _body(gathered, part)
            gathered = []
            label = next((w for w in LABELS if line.startswith(w + " ")), "")
            if line.startswith("CASE"):
                part += 1
            text = line.removeprefix(label).strip()
            yield Row(label.lower() or "heading", text, part)
        elif label:
            yield Row(f"{label.lower()} on", line.strip(), part)
        else:
            gathered.append(line)
    yield from _body(gathered, part)


def _body(lines: list[str], part: int) -> Iterator[Row]:
    """Sentences, force lists and equations between two headings."""
    joined: list[list[str]] = []
    hangs: tuple[int, ...] = ()
    for line in lines:
        indent = len(line) - len(line.lstrip())
        goes_on = indent in hangs and not re.match(r"\(\d+\)  ", line.strip())
        if joined and (goes_on or _GOES_ON.match(line) or _OPEN.match(joined[-1][-1])):
            joined[-1].append(line.strip())
            continue
        joined.append([line])
        hangs = _hangs(line, indent)
    for rows in joined:
        yield from _one_by_one(_row(" ".join([rows[0].rstrip(), *rows[1:]]), part))


def _one_by_one(row: Row) -> Iterator[Row]:
    """The equations of a row that says several values: x_2 = 1 m,  v_2 = 3 m/s."""
    pieces = re.split(r",  ", row.text) if row.kind == "equation" else []
    if len(pieces) < 2 or not all(re.search(r"\S = \S", p) for p in pieces):
        yield row
        return
    for piece in pieces:
        yield _row(f"     {piece}", row.part)


def _hangs(line: str, indent: int) -> tuple[int, ...]:
    """The columns at which the rows that continue a line stand."""
    if drawn := _DRAWN.match(line):
        return (drawn.end(), drawn.end() - 2, 4)
    if indent < 3 and not _LED.match(line):
        return (indent + 2,) if line.lstrip()[0] in "•⇒" else ()
    sign = re.search(r" (=|≤|≥|<|>|≈) ", line)
    column = sign.start() + 1 if sign else WIDTH
    return (column,) if column <= WIDTH // 2 else (indent + 2,)


ARROWS = "↑↓←→↖↗↘↙↺↻"
_DRAWN = re.compile(rf"  \S[^:=Σ]*:  *(?=[^=Σ]*[{ARROWS}])")
_GOES_ON = re.compile(r"    +[=+·/-] ")
_OPEN = re.compile(r"    \s*(?:\(\d+\)\s*)?(?:\S.*:)?$")
_LED = re.compile(r"  \S.*?:   +\S.* = ")


def _row(line: str, part: int) -> Row:
    text = line.strip()
    if _DRAWN.match(line):
        left, _, right = text.partition(" = ")
        label, _, acting = left.partition(":")
        return Row("forces", text, part, None, label, (acting.strip(), right.strip()))
    if text[0] in "•⇒" or (re.match(r"  \S", line) and not _LED.match(line)):
        return Row("text", text, part)
    number = re.match(r"\((\d+)\)  +", text)
    rest = text[number.end() :] if number else text
    lead = re.match(r"(.*?:)(?:  +|$)", rest)
    body = rest[lead.end() :] if lead else rest
    body = re.split(r"   +", body.strip())[0]
    sides = tuple(s.strip() for s in SIDES.split(body))
    return Row("equation", text, part, int(number[1]) if number else None, lead[1] if lead else "", sides)


# --- pieces ----------------------------------------------------------------------------------------------------------


def symbols(text: str) -> list[str]:
    """The letters of a formula, functions left out."""
    return [s for s in SYMBOL.findall(_bare(text)) if s not in FUNCTIONS]


def cited_in(text: str) -> set[int]:
    """The numbers of the equations that a line names: (1), (3), and all of (5) to (8)."""
    found = {int(n) for n in re.findall(r"\((\d+)\)", text)}
    for first, last in re.findall(r"\((\d+)\) to \((\d+)\)", text):
        found |= set(range(int(first), int(last) + 1))
    return found


def _bare(text: str) -> str:
    text = re.sub("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", "", text)
    return re.sub(r"by (?:numerical integration|quadrature)|\[|\]|→", " ", text)


def value_of(side: str) -> tuple[float, str] | None:
    """Number and unit of a side that is a value; None: it is a formula."""
    match = re.fullmatch(rf"({NUMBER})(°| [^\s·]+(?:·\S+)*)?(?:[,;]? (?:{_AFTER}).*)?", side.strip())
    if match is None:
        return None
    unit = (match[2] or "").strip()
    if unit and not _UNIT.fullmatch(unit):
        return None
    digits = match[1].split("×10")
    power = int(digits[1].translate(_SUPER)) if len(digits) > 1 else 0
    return float(digits[0]) * 10.0**power, unit


_PLAIN = "°|rad|rev|rpm|m|mm|cm|km|ft|in|mi|s|min|h|kg|g|t|N|kN|lbf|lb|slug|J|kJ|W|kW|hp|Hz|mph|Pa|kPa|1|kt|%"
_UNIT = re.compile(rf"(?:{_PLAIN})[²³]?(?:[·/](?:\(?(?:{_PLAIN})[²³]?(?:·(?:{_PLAIN})[²³]?)*\)?))*")
_AFTER = "to the|upward|downward|clockwise|counterclockwise|by |in tension|in compression|that is|at |above|below|along"
_AFTER += r"|up the|down the|perpendicular|\(asked|in the direction|against the direction|beyond it"
_SUPER = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def is_numbers(side: str) -> bool:
    """Is it a formula of numbers alone?"""
    return value_of(side) is None and not symbols(side)


@dataclass(frozen=True, slots=True)
class Told:
    """One answer: its name, the letter of the solution that it is said to be, what follows, its part of the page, and
    its number where it has one.
    """

    name: str
    letter: str
    text: str
    part: int
    value: tuple[float, str] | None


SENSE = re.compile(
    r",?(?: that is)? (?:clockwise|counterclockwise|upward|downward|to the left|to the right)$"
    r"| (?:in|against) the direction of motion$|; (?:beyond|below) it .*$"
)
"""What a formula as an answer has behind it."""


def answers(page: Page) -> list[Told]:
    """The answers of a page; words such as "yes" and curves have neither number nor formula and are left out."""
    rows: list[list[str]] = []
    parts = []
    for r in page.of("answer", "answer on"):
        if r.kind == "answer" or re.match(r"\S+(?: = |: )", r.text):
            rows.append([r.text])
            parts.append(r.part)
        else:
            rows[-1].append(r.text)
    found = []
    for lines, part in zip(rows, parts, strict=True):
        name, sign, text = " ".join(lines).partition(" = ")
        if sign and ": " not in name:
            letter, equal, rest = text.partition(" = ")
            if not equal or len(letter.split()) > 1 or not symbols(letter):
                letter, rest = name, text
            head, _, turned = rest.partition(", that is ")
            signed = turned if turned and value_of(head) else rest
            if value_of(SENSE.sub("", signed)) is None and symbols(SENSE.sub("", signed)):
                signed = SENSE.sub("", signed)
            if value_of(signed) is None:
                # Of a formula with its number in decimals behind it the line is that of the formula.
                signed = signed.partition(" = ")[0]
            # |ṡ_2|, and -ṡ_2, are told by the line of ṡ_2.
            found.append(Told(name, letter.lstrip("-").strip("|"), signed, part, value_of(signed)))
    return found


def _same(a: tuple[float, str], b: tuple[float, str]) -> bool:
    """Is it the same size, apart from its sign? Units are left aside: a line counts in SI units."""
    return any(abs(abs(a[0]) - abs(b[0] * f)) <= 6e-4 * abs(a[0]) for f in _factors(b[1], a[1]))


def _factors(old: str, new: str) -> list[float]:
    """By what a number in one unit becomes one in the other, as far as pages need it."""
    if old == new or not old or not new:
        return [1.0]
    sizes = {"mm": 1e-3, "cm": 1e-2, "km": 1e3, "ft": 0.3048, "in": 0.0254, "rpm": 0.104719755, "rev": 6.283185307}
    sizes |= {"mph": 0.44704, "km/h": 1 / 3.6, "lbf": 4.4482216, "kW": 1e3, "kN": 1e3, "min": 60.0, "h": 3600.0}
    sizes |= {
        "°": 0.017453292519943295,
        "mi": 1609.344,
        "in/s": 0.0254,
        "in/s²": 0.0254,
        "mm/s": 1e-3,
        "mm/s²": 1e-3,
        "ft/s": 0.3048,
        "ft/s²": 0.3048,
        "g": 1e-3,
        "kJ": 1e3,
    }
    return [sizes.get(old, 1.0) / sizes.get(new, 1.0)]


def base(name: str) -> str:
    """A letter without the state that it belongs to: the last piece of a subscript where it is one of several."""
    return re.sub(r"[_,][^_,]*$", "", name)


# --- rules -----------------------------------------------------------------------------------------------------------


def standing(page: Page, answer: Told) -> str:
    """How an answer is derived: "full", "other" (a full line under another name), "short" (a line without formula or
    without numbers), "bare" (the number alone), "none".
    """
    best, solved = "none", set[tuple[int, str]]()
    for r in page.of("equation"):
        if r.part > answer.part or len(r.sides) < 2 or r.is_datum:
            continue
        best = min(best, _grade(r, answer, (r.part, r.left) in solved), key=GRADES.index)
        if len(r.sides) == 2 and symbols(r.sides[1]) and value_of(r.sides[1]) is None:
            solved.add((r.part, r.left))
    return "full" if best == "none" and _by_components(page, answer) else best


def _by_components(page: Page, answer: Told) -> bool:
    """Is a vector in letters told by a line for each of its components, ẋ_P and ẏ_P?"""
    vector = re.match(r"\[(.+), ([^,]+)\]", answer.text)
    if answer.value is not None or vector is None:
        return False
    told = {r.sides[-1] for r in page.of("equation") if r.part <= answer.part and len(r.sides) > 1}
    return all(part in told | {"0"} for part in vector.groups()) and bool(symbols(answer.text))


GRADES = ("full", "other", "short", "bare", "none")


def _grade(r: Row, answer: Told, solved: bool) -> str:
    """`solved`: its formula stands on a line before."""
    left = r.left
    own = left in (answer.name, answer.letter, f"{answer.name}, x", f"{answer.name}, y") or base(left) == answer.name
    own = own or any(answer.letter == v or answer.name == base(v) for v in _vectors_of(left))
    if along := re.fullmatch(r"(\S+) · [eu]′?", left):
        left, own = along[1], along[1] == answer.letter
    if answer.value is None:
        if answer.text.startswith("["):
            return ("full" if len(r.sides) > 2 else "short") if own else "none"
        if r.sides[-1] == answer.text or answer.text in r.sides:
            return "full" if own else "other"
        return "none"
    values = [v for side in r.sides[1:] if (v := value_of(side) or _along_an_axis(side))]
    if not any(_same(answer.value, v) for v in values):
        return "none"
    if re.match(r"-?[\d(√]", left) or " " in left:
        return "none"
    formula = solved or any(symbols(side) and value_of(side) is None for side in r.sides[1:])
    numbers = any(is_numbers(side) for side in r.sides[1:])
    # A line that only gives another name to what was found, v_max = v_2 = 3 m/s, does not derive it.
    if formula and numbers:
        return "full" if own else "other"
    return "short" if formula or numbers else "bare"


def _vectors_of(left: str) -> set[str]:
    """The vectors of which a letter may be a component: v_B,2 of v_Bx,2, and r_B,2 of x_B,2."""
    parts = {re.sub(r"(?<=[A-Z\d])[xy](?=,|$)", "", left), re.sub(r",[xy](?=,|$)", "", left)} - {left}
    return parts | ({f"r{left[1:]}"} if left[:2] in ("x_", "y_") else set())


def _along_an_axis(side: str) -> tuple[float, str] | None:
    """The size of a vector in numbers that has one component alone."""
    vector = re.fullmatch(rf"\[({NUMBER}), ({NUMBER})\]( \S+)?", side)
    if vector is None or "0" not in vector.groups()[:2]:
        return None
    return value_of(f"{vector[1] if vector[2] == '0' else vector[2]}{vector[3] or ''}")


def unknowns_bare(page: Page) -> Iterator[str]:
    """Rule 2: an unknown solved by a number alone."""
    numeric = {(r.part, r.number) for r in page.of("equation") if r.numeric and r.number}
    numeric |= {(r.part, n) for r in page.of("equation") if r.numeric for n in cited_in(r.lead)}
    for r in page.of("equation"):
        cited = {(r.part, n) for n in cited_in(r.lead)}
        if cited and cited & numeric:
            continue
        solved = re.fullmatch(r"\(\d+\).*:|(?:\S+: )?by numerical integration:|.* of \S+:", r.lead)
        single = len(r.sides) == 2
        if single and r.lead.startswith("mass of") and r.sides[1].endswith(" m"):
            # Twice a mass m, which only looks like two metres.
            continue
        integrated = single and re.search("by (numerical integration|quadrature)", r.sides[1])
        if integrated or (solved and single and (v := value_of(r.sides[1])) and v[0]):
            yield r.text


KINEMATIC_WORDS = (
    "across which nothing moves",
    "follows its formula",
    "drops out",
    "keeps the distance from the line",
    "keeps its length",
    "is a point of",
    "is the same point of",
    "about which the group turns in a virtual motion",
    "what keeps ",
)
REASONS = (
    "it moves the other way there",
    "this motion does not come there",
    "that is not after the state before",
    "a later instant",
    "the first instant after the state before counts",
    "changes its sign at",
    "no distribution of the reactions keeps",
    "in no time",
    "nothing acts that way",
    "the velocities contradict it",
    "the equations contradict it",
    "the smaller one is usual",
)
HOUSE_WORDS = (
    "residuals",
    "multibody solution agrees to",
    "followed step by step",
    "agree with the motion followed",
    "by independent facts",
    "solved at once for all bodies",
    "not compared",
    " digits",
    "not in this scene",
    "as drawn",
    "in these letters",
    "From state to state",
    "the integrand is the rate of",
    "SPAN",
    "in no time",
    "Largest block",
    "step by step",
    "it is drawn back",
    "which the file leaves open",
    "nothing that is asked or acts names it",
    "throughout the motion: ",
)


def phrases(page: Page, forbidden: tuple[str, ...]) -> Iterator[str]:
    """Lines with a phrase that has no place on a page."""
    labels = ("text", "heading", "equation", *(w.lower() for w in LABELS), *(f"{w.lower()} on" for w in LABELS))
    for r in page.of(*labels):
        # A length that is kept may be said where its formula stands.
        if any(p in r.text for p in forbidden) and "= const." not in r.text:
            yield r.text


def decimals(page: Page) -> Iterator[str]:
    """Rule 4: a formula of letters with a decimal in it."""
    for r in (r for r in page.of("equation") if not r.numeric):
        for side in r.sides:
            if re.fullmatch(r"\[[^\]]*\](?: \S+)?", side):
                continue
            if value_of(side) is None and re.search(r"\d\.\d", side) and symbols(_without_units(side)):
                yield f"{r.left} = … {side}"


def _without_units(side: str) -> str:
    # The angle of a sine has its unit in any formula of numbers.
    side = re.sub(rf"\({NUMBER} rad\)", "()", side)
    return re.sub(rf"{NUMBER}\s(?:{_UNIT.pattern})(?=$|[\s,)])", " ", side) if side.count(" ") < 3 else side


def formulas(page: Page) -> int:
    """How many formulas of letters a page has."""
    return sum(value_of(s) is None and bool(symbols(s)) for r in page.of("equation") for s in r.sides)


def swallowed(page: Page) -> Iterator[str]:
    """Rule 4: a sum of letters with a number among its terms, which has lost its unit."""
    for r in (r for r in page.of("equation") if not r.numeric):
        for side in r.sides:
            terms = re.split(r" [+-] ", _flat(side))
            if len(terms) > 1 and symbols(side) and any(re.fullmatch(r"-?\d+(?:\.\d+)?", t) for t in terms):
                yield f"{r.left} = … {side}"


def _flat(side: str) -> str:
    """A formula without what stands in brackets."""
    while (inner := re.sub(r"\([^()]*\)", "_", side)) != side:
        side = inner
    return side


def diagrams(page: Page) -> Iterator[str]:
    """Rule 5: force lists with a body for a place, a norm, a couple without its name, or without m a. A particle of a
    group is a place in its list.
    """
    labels = {r.lead for r in page.of("forces")}
    for r in page.of("forces"):
        places = re.findall(r" at ([\w.]+)", " ".join(r.sides))
        group = r.lead.rstrip(":").split(", ")
        if any(p in labels and len(p) > 1 for p in places if len(group) < 2 or p not in group):
            yield f"at body: {r.text}"
        if re.search(r"√\(.*(sin|cos)².*(sin|cos)²", r.sides[1]):
            yield f"norm: {r.text}"
        if re.search(r" \d+ ↺|-\S+ ↺| -\S", r.sides[0]):
            yield f"sense: {r.text}"
        if r.sides[1] and not re.search(r" [↑↓←→↖↗↘↙]", r.sides[1]) and r.sides[1] != "0" and not _central(r.sides[0]):
            yield f"no m a: {r.text}"


def _central(acting: str) -> bool:
    weight = re.search(r" g ↓ at ([\w.]+)", acting)
    return weight is None or len(re.findall(rf" at {re.escape(weight[1])}(?![\w.])", acting)) > 1


def axes(page: Page) -> Iterator[str]:
    """Rule 5: a sum of forces whose arrow is not that of a term m a that stands in it alone."""
    drawn = {}
    for r in page.of("forces"):
        for piece in (p for side in r.sides[:2] for p in re.split(r",  ?", side)):
            if match := re.match(rf"(.*?) ([{ARROWS}])", piece.strip()):
                drawn.setdefault(match[1], set()).add(match[2])
    opposite = dict(zip("↑↓←→↖↗↘↙", "↓↑→←↘↙↖↗", strict=True))
    for r in page.of("equation"):
        if match := re.match(r"([↖↗↘↙]) ΣF", r.lead):
            for side in r.sides:
                for sign, term in re.findall(r"(^-?|[+-] )([^+-]+?)(?= [+-] |$)", side):
                    arrows = drawn.get(term.strip(), set())
                    wrong = match[1] if sign.strip() == "-" else opposite[match[1]]
                    if wrong in arrows and len(arrows) == 1:
                        yield f"{r.text}   [{term} {arrows}]"


def unused(page: Page) -> Iterator[str]:
    """Rule 6: a numbered equation on which no answer, check or later line rests."""
    rows = page.of("equation", "text")
    told = answers(page)
    needed = {t for r in page.of("check", "check on", "answer", "answer on", "discussion") for t in symbols(r.text)}
    numbers: set[tuple[int, int]] = set()
    kept = []
    integrated: set[int] = set()
    for r in reversed(rows):
        if "∫" in r.text or r.text.startswith("The law") or _LAW_OF_MOTION.search(r.text):
            integrated.add(r.part)
        if r.kind == "text":
            if "together" in r.text or "the accelerations in these by" in r.text:
                numbers |= {(r.part, n) for n in cited_in(r.text)}
            continue
        cited = {(r.part, n) for n in cited_in(r.lead)}
        letters = set(symbols(r.left))
        single = len(r.left.split()) == 1
        value = [v for s in r.sides[1:] if (v := value_of(s))]
        result = any(a.value and _same(a.value, v) for v in value[-1:] for a in told if a.part >= r.part)
        same = any(a.value is None and a.text in r.sides for a in told)
        near = bool(letters & needed) or any(base(x) in needed for x in letters)
        # What is said to be zero leaves the equations that follow.
        nil = re.search(r"hence \S+ = 0$", r.text) or (single and re.fullmatch(r"0(?: \S+)?", r.sides[-1]))
        used = (
            bool(nil) or result or same or (single and near) or (r.number is not None and (r.part, r.number) in numbers)
        )
        if (not single and r.number is None) or (r.part in integrated and re.match("[avωα]|.\u0307|.\u0308", r.left)):
            used = True
        if used:
            kept.append(r)
            numbers |= cited
            needed |= {t for s in r.sides for t in symbols(s)}
        elif r.number is not None or cited:
            yield r.text


_LAW_OF_MOTION = re.compile(
    "equation of motion|constant (?:angular )?acceleration|simple harmonic|under-damped|^For (the|.* of)|Compared with"
)
"""What a page says where it goes on from an acceleration, whose letter the lines below do not name again."""


def repeated(page: Page) -> Iterator[str]:
    """Rule 7: a line that stood word for word in an earlier case."""
    before: set[str] = set()
    part = 0
    now: set[str] = set()
    for r in page.of("equation", "forces", "text"):
        if r.part != part:
            part, before, now = r.part, before | now, set()
        text = re.sub(r"^\(\d+\)\s+", "", r.text)
        if text in before and len(text) > 12:
            yield text
        now.add(text)


def renamed(page: Page) -> Iterator[str]:
    """Rule 8: an answer under another name than its line, or of the other sign without a word of direction."""
    rows = [r for r in page.of("equation") if len(r.sides) > 1 and len(r.left.split()) == 1 and not r.is_datum]
    for a in answers(page):
        if a.value is None or not a.value[0]:
            continue
        same = [r for r in rows if r.part <= a.part and (v := value_of(r.sides[-1])) and _same(a.value, v)]
        own = [r for r in same if r.left in (a.name, a.letter) or base(r.left) == a.name]
        if same and not own:
            yield f"name: {a.name} for {same[-1].left}"
        for r in own[-1:]:
            v = value_of(r.sides[-1])
            words = re.search("clockwise|to the|upward|downward|above|below|the direction of motion", a.text)
            if v and v[0] * a.value[0] < 0 and not words:
                yield f"sign: {a.name}: {r.text}"
    states = {word for r in page.rows for word in re.findall(r"\b(?:At|to) (\w+)", r.text)}
    for r in page.of("equation"):
        if (found := re.search(r"[av]_([a-z]{3,}[xy])(?:[,\s]|$)", r.text)) and found[1] not in states:
            yield f"axis: {found[0]}"


Rule = Callable[[Page], Iterator[str]]
