"""One student's submission from a tree of nodes; nothing but `answers`, `student` and `variant` is ever looked at.

    student: s123               # else the name of the file
    variant: 3                  # else 0
    answers:
      incline: {a: 3.2 m/s^2, N: {value: 12.5, unit: N}}
      crank.v: {x: 3, y: -4, unit: m/s}

An answer is one text; a list or mapping is written out as one: `12.5 N`, `[3, -4] m/s`, `10 N at 30 deg`. Its own
unit goes before one that stands beside it, as on a sheet where that was printed.
"""

from __future__ import annotations

import os
import re

from planar_cli.errors import Mark
from planar_cli.homework.sets.paper import Submission
from planar_cli.problem.nodes.nodes import Mapping, Node, Scalar, Sequence, is_null
from planar_cli.problem.nodes.show import visible

KEYS = ("answers", "student", "variant")
LONGEST_NAME = 100
MOST_ANSWERS = 2000
MOST_COMPONENTS = 50
MOST_TOLD = 20
NOT_IN_A_COMPONENT = re.compile(r"[,;\[\]()<>]")
NO_UNITS = ("", "1", "-", "–")
ARITHMETIC = set("e E x pi sqrt sin cos tan asin acos atan exp log ln".split())
"""Words of a number that is worked out; any other word of an answer is a unit, a direction or a letter."""
WORD = re.compile(r"[^\W\d_]+|°")
DIRECTED = re.compile(
    r"(.*[0-9.)\]>])\s*"
    r"((?:cw|ccw|(?:counter-?|anti-?)?clockwise|up|down|left|right|to the|at)\b.*|[@∠↺↻→←↑↓].*)",
    re.IGNORECASE,
)
HOW = "write `12.5 N`, `{value: 12.5, unit: N}`, `[3, 4] m/s` or `{x: 3, y: 4, unit: m/s}`"


def sentence(mark: Mark, message: str, hint: str = "") -> str:
    """What is wrong, behind its place, on one line that any terminal may print."""
    place = f"{mark.file}:{mark.line}:{mark.column}" if mark.line else mark.file
    return visible(f"{place}: {message}{f'; {hint}' if hint else ''}")


def student_of_file(path: str) -> str:
    """Whose a file is that does not say it."""
    return visible(os.path.splitext(os.path.basename(path))[0])[:LONGEST_NAME]


class Handed:
    """A submission while it is read. An answer that stands twice is left out: nobody knows which is meant."""

    def __init__(self, student: str, source: str, variant: int = 0) -> None:
        self.student, self.source, self.variant = student, source, variant
        self.answers: dict[tuple[str, str], tuple[str, Mark]] = {}
        self.twice: set[tuple[str, str]] = set()
        self.wrong: list[str] = []
        self.usable = True

    def complain(self, mark: Mark, message: str, hint: str = "") -> None:
        """Tell it, unless so much is told that nobody would read on."""
        if len(self.wrong) < MOST_TOLD:
            self.wrong.append(sentence(mark, message, hint))

    def name(self, text: str, mark: Mark) -> None:
        """Whose it is."""
        if len(text) > LONGEST_NAME:
            self.complain(mark, f"the name of a student is at most {LONGEST_NAME} characters long")
        self.student = visible(text[:LONGEST_NAME])

    def vary(self, text: str, mark: Mark) -> None:
        """Which variant it answers: without that nothing is graded."""
        if re.fullmatch(r"[0-9]{1,9}", text):
            self.variant = int(text)
            return
        self.usable = False
        self.complain(mark, f"`{text[:20]}` is no number of a variant", "write `variant: 3`, as on your sheet")

    def answer(self, problem: str, find: str, text: str, mark: Mark) -> None:
        """Take an answer; an empty one is none."""
        text, key = text.strip(), (problem.strip(), find.strip())
        if not text:
            return
        if key in self.answers:
            line = self.answers[key][1].line
            first = f"; the first is in line {line}" if line else ""
            self.complain(mark, f"`{key[0]}.{key[1]}` is answered a second time{first}", "neither is graded")
            self.twice.add(key)
        elif len(self.answers) == MOST_ANSWERS:
            self.complain(mark, f"a submission has at most {MOST_ANSWERS} answers")
        else:
            self.answers[key] = text, mark

    def submission(self) -> Submission:
        """What was gathered."""
        kept = [(*key, text) for key, (text, _) in self.answers.items() if self.usable and key not in self.twice]
        return Submission(self.student, self.variant, tuple(kept), self.source, tuple(self.wrong))


def from_tree(tree: Node, path: str) -> Submission:
    """The submission of a file that holds one student's."""
    handed = Handed(student_of_file(path), path)
    if not isinstance(tree, Mapping):
        handed.complain(tree.mark, "there are no `answers`", "write `answers:` and below it what you found")
        return handed.submission()
    for key, value in tree.pairs:
        if key.text not in KEYS:
            handed.complain(key.mark, f"`{key.text}` is not read", f"a submission has {', '.join(KEYS)}")
        elif key.text == "answers":
            _answers(handed, value)
        elif not isinstance(value, Scalar):
            handed.usable = handed.usable and key.text != "variant"
            handed.complain(value.mark, f"`{key.text}` is one word", f"write `{key.text}: …`")
        elif not is_null(value):
            (handed.name if key.text == "student" else handed.vary)(value.text.strip(), value.mark)
    if tree.get("answers") is None:
        handed.complain(tree.mark, "there are no `answers`", "write `answers:` and below it what you found")
    return handed.submission()


def _answers(handed: Handed, node: Node) -> None:
    if isinstance(node, Scalar) and is_null(node):
        return
    if not isinstance(node, Mapping):
        handed.complain(node.mark, "answers stand by name", "write `problem: {find: answer}` or `problem.find: answer`")
        return
    for key, value in node.pairs:
        problem, dot, find = key.text.partition(".")
        if dot:
            _answer(handed, problem, find, value)
        elif isinstance(value, Mapping):
            for inner, answer in value.pairs:
                _answer(handed, problem, inner.text, answer)
        elif not (isinstance(value, Scalar) and is_null(value)):
            hint = f"write `{key.text}: {{find: answer}}` or `{key.text}.find: answer`"
            handed.complain(key.mark, f"`{key.text}` does not say what it answers", hint)


def _answer(handed: Handed, problem: str, find: str, node: Node) -> None:
    text = typed(node)
    if text is None:
        handed.complain(node.mark, f"`{problem}.{find}` is no answer that can be read", HOW)
    elif not text.isprintable() and not all(c.isprintable() or c in "\n\t" for c in text):
        handed.complain(node.mark, f"`{problem}.{find}` has a character that cannot be seen", "type the answer anew")
    else:
        handed.answer(problem, find, text, node.mark)


def typed(node: Node) -> str | None:
    """An answer as one text, "" if there is none; None if it is no answer."""
    match node:
        case Scalar():
            return "" if is_null(node) else node.text
        case Sequence(items):
            return _components(items)
        case Mapping(pairs):
            return _written_out({key.text: value for key, value in pairs})


def _components(items: tuple[Node, ...]) -> str | None:
    texts = [item.text.strip() for item in items if isinstance(item, Scalar) and not is_null(item)]
    if not len(texts) == len(items) <= MOST_COMPONENTS or any(NOT_IN_A_COMPONENT.search(t) for t in texts):
        return None
    return f"[{', '.join(texts)}]"


def _written_out(parts: dict[str, Node]) -> str | None:
    unit = parts.pop("unit", None)
    if unit is not None and not isinstance(unit, Scalar):
        return None
    behind = "" if unit is None or is_null(unit) else unit.text.strip()
    match parts:
        case {"value": (Scalar() | Sequence()) as value} if len(parts) == 1:
            text = typed(value)
            return with_unit(text, behind) if text else text
        case {"x": Scalar() as x, "y": Scalar() as y} if len(parts) == 2:
            text = _components((x, y))
            return text and with_unit(text, behind)
        case {"magnitude": Scalar() as size, "angle": Scalar() as angle} if len(parts) == 2:
            return f"{with_unit(size.text.strip(), behind)} at {angle.text.strip()}"
    return None


def with_unit(answer: str, unit: str) -> str:
    """An answer with the unit that stands beside it, unless it has its own, or is a word or formula.

    `6.2 cw` and `rad/s` become `6.2 rad/s cw`; the `1` of a pure number is none.
    """
    if unit in NO_UNITS:
        return answer
    directed = DIRECTED.fullmatch(answer)
    number, direction = (directed[1], f" {directed[2]}") if directed is not None else (answer, "")
    bare = any(c.isdigit() for c in number) and all(word in ARITHMETIC for word in WORD.findall(number))
    return f"{number} {unit}{direction}" if bare else answer
