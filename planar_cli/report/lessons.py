"""What a lesson says beside the solution: what each step is for, and which trap it avoids. It repeats no equation."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from planar_cli.records import record
from planar_cli.report.blocks import Block, Equation, Heading, Inline, Line, Name, Note, Paragraph, Text, line


@record
class Lesson:
    """Words about a step, told once on a page where `applies` to the blocks of the step."""

    step: str
    """With this the heading of the step begins; empty: any step."""
    applies: Callable[[Sequence[Block]], bool]
    words: str


def with_lessons(blocks: Sequence[Block]) -> list[Block]:
    """The page with the words of the lesson behind the headings of its steps, each once."""
    found: list[Block] = []
    told: set[str] = set()
    for heading, body in _steps(blocks):
        if heading is not None:
            found.append(heading)
            found += [Paragraph(line(Text(words, "muted"))) for words in _words(heading, body) if words not in told]
            told.update(_words(heading, body))
        found += body
    return found


def _steps(blocks: Sequence[Block]) -> Iterator[tuple[Heading | None, list[Block]]]:
    """Headings with what stands under them."""
    heading: Heading | None = None
    body: list[Block] = []
    for block in blocks:
        if isinstance(block, Heading):
            yield heading, body
            heading, body = block, []
        else:
            body.append(block)
    yield heading, body


def _words(heading: Heading, body: Sequence[Block]) -> list[str]:
    if not heading.label.startswith("STEP"):
        return []
    return [x.words for x in LESSONS if heading.text.startswith(x.step) and x.applies(body)]


def _names(body: Sequence[Block]) -> set[str]:
    """All names that stand in the equations and sentences of a step."""
    found: set[str] = set()
    for block in body:
        lines: list[Inline | Line] = []
        if isinstance(block, Equation):
            lines = [*block.sides, block.lead, block.note]
        elif isinstance(block, Paragraph | Note):
            lines = [block.line]
        for part in lines:
            found |= {p.name for p in (part if isinstance(part, tuple) else (part,)) if isinstance(p, Name)}
    return found


def _texts(body: Sequence[Block]) -> str:
    """The words of the sentences of a step."""
    said = (p.text for b in body if isinstance(b, Paragraph) for p in b.line if isinstance(p, Text))
    return " ".join(said)


def _has(*names: str) -> Callable[[Sequence[Block]], bool]:
    return lambda body: bool(set(names) & _names(body))


def _says(*words: str) -> Callable[[Sequence[Block]], bool]:
    return lambda body: any(w in _texts(body) for w in words)


def _begins(start: str) -> Callable[[Sequence[Block]], bool]:
    return lambda body: any(n.startswith(start) for n in _names(body))


def _always(body: Sequence[Block]) -> bool:
    return bool(body)


LESSONS = (
    Lesson(
        "Kinematic analysis",
        _always,
        "Motion comes before force: every joint relates velocities and accelerations, and each relation that is "
        "found here is one unknown less later. Write the relation between two points of one body as a vector "
        "equation first, and only then choose the component that leaves out what you do not know.",
    ),
    Lesson(
        "Kinematic analysis",
        _has("v_rel"),
        "A point that slides on a turning body: its velocity is that of the point of the body under it plus the "
        "relative velocity. In the acceleration a third part comes in, twice the angular velocity of the body "
        "times the relative velocity. It is there even where the point slides at a constant rate; to leave it out"
        " is the usual mistake.",
    ),
    Lesson(
        "Kinematic analysis",
        _says("rolls on", "does not slip"),
        "Rolling without slipping makes the velocities at the contact equal, and the accelerations along it. The "
        "accelerations across it are not equal: the point of contact of a rolling wheel is accelerated.",
    ),
    Lesson(
        "Kinetic analysis",
        _always,
        "Each body is drawn alone with every force that acts on it, and beside it what these forces amount to: "
        "the mass times the acceleration of the mass centre, and the moment of inertia times the angular "
        "acceleration. The forces of a joint act on both of its bodies in opposite directions. Mass times "
        "acceleration is no force.",
    ),
    Lesson(
        "Kinetic analysis",
        _begins("ΣM_"),
        "Moments may be taken about any point, if the mass times acceleration at the mass centre is given its "
        "moment about it too. A point in which unknown forces meet spares them. Only about the mass centre, or "
        "about a fixed point with the moment of inertia about that point, is the angular acceleration all that "
        "stands on the right.",
    ),
    Lesson(
        "Kinetic analysis",
        _begins("F_"),
        "The friction of a contact that does not slip is an unknown that the equations give; it is compared with "
        "its limit afterwards. Only where it slips is it the coefficient times the normal force, against the "
        "slip.",
    ),
    Lesson(
        "Solving the equations",
        _always,
        "Take the equations in the order in which each gives one new unknown. Keep the letters as long as they "
        "stay short: a formula can be tested by its units and by simple cases, a number can not.",
    ),
    Lesson(
        "",
        _begins("T_"),
        "Speeds at two places and no time asked: work and kinetic energy. Forces at points at rest, and forces "
        "across the motion, do no work. A body that moves and turns has both parts of the kinetic energy.",
    ),
    Lesson(
        "",
        _says("momentum before"),
        "A blow is so short that nothing changes its place meanwhile and that weights and springs have no impulse"
        " worth naming; the reactions of supports have. Take angular momentum about a point through which the "
        "unknown impulses pass.",
    ),
    Lesson(
        "",
        _says("constant acceleration", "constant angular acceleration"),
        "The acceleration is constant, so that v = v₀ + a t, x = x₀ + v₀ t + a t²/2 and v² = v₀² + 2 a (x - x₀), of "
        "which two are independent: take the one without what is neither given nor asked.",
    ),
    Lesson(
        "",
        _says("v dv = a", "dv = a dt", "ω dω = α dθ", "dω = α dt", "dv/a = dt"),
        "The acceleration depends on time, on speed or on place: separate the variables accordingly, and take the"
        " limits of both integrals at the same two states.",
    ),
)
"""In the order in which they are told under one heading."""
