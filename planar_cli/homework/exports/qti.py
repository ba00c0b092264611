"""QTI 2.1: a content package of assessment items."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Collection, Mapping, Sequence
from typing import ClassVar, final

from planar_cli.homework.exports._asked import (
    Asked,
    Interval,
    LeftOut,
    Number,
    alternatives,
    finds,
    is_numeric,
    name_of,
    numbers,
    problems,
    question_of,
    shown_unit,
    text_of,
)
from planar_cli.homework.exports._figure import SUFFIX, Figure, figure_of
from planar_cli.homework.exports._text import Names, bullets, html, number, one_line, paragraphs, slug, xml
from planar_cli.homework.exports._xml import DECLARATION, element
from planar_cli.homework.exports.base import Exported, PaperExport
from planar_cli.homework.sets.paper import Paper

ITEMS = "http://www.imsglobal.org/xsd/imsqti_v2p1"
PACKAGE = "http://www.imsglobal.org/xsd/imscp_v1p1"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
WHERE_ITEMS = f"{ITEMS} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd"
WHERE_PACKAGE = f"{PACKAGE} http://www.imsglobal.org/xsd/qti/qtiv2p1/qtiv2p1_imscpv1p2_v1p0.xsd"
ITEM_TYPE = "imsqti_item_xmlv2p1"
LONGEST_TITLE = 255
NEVER = (1980, 1, 1, 0, 0, 0)
"""The time of every member of the archive: the earliest that it can tell."""
SCORE = "SCORE"


@final
class Qti(PaperExport):
    """Items of QTI 2.1 in a content package, which many course systems import.

    The file
        A zip with `imsmanifest.xml` and one item for each find and variant. A number is typed; it is right within the
        tolerance of `planar check`, and a direction after a whole turn too. A vector or list has one field for each
        number, which shares the points. Yes or no becomes a choice; another word is typed. Diagnosed
        mistakes score nothing and show their feedback; after answering the worked solution is shown. Beside an item
        lies the figure of its sheet, the scene as it is given, as SVG, which the item shows below the text.

    To import it
        As a QTI 2.1 content package, for instance in TAO, OpenOlat or Canvas New Quizzes. Formulas of the worked
        solution stand in LaTeX between \\( and \\); the system's MathJax shows them.

    What is lost
        Formulas as answers. Units: students type the number in the unit that the item names. Systems differ in
        whether they show feedback of items. Errors carried forward, and sign and precision as verdicts of their own.
    """

    kind: ClassVar[str] = "qti"

    def export(self, papers: Sequence[Paper], title: str, seed: int) -> Exported:
        left_out, names = LeftOut(), Names()
        items: dict[str, str] = {}
        figures: dict[str, bytes] = {}
        for variants in problems(papers).values():
            for of_one in finds(variants).values():
                for asked in of_one:
                    content = _content(asked, left_out)
                    if content is not None:
                        name = names.of(slug(f"{asked.task.problem}-{asked.expected.find}", f"-v{asked.variant}"))
                        figure = figure_of(asked.task)
                        figures |= {name: figure.data} if figure is not None else {}
                        items[name] = _item(name, asked, content, figure)
        files = {f"items/{name}.xml": item.encode() for name, item in items.items()}
        files |= {f"items/{name}{SUFFIX}": drawn for name, drawn in figures.items()}
        files["imsmanifest.xml"] = _manifest(title, seed, list(items), figures).encode()
        return Exported({f"{slug(title)}.zip": _zipped(files)}, left_out.sentences())


class _Content:
    """What differs from item to item: declarations, the body behind the text, and how it is scored."""

    def __init__(self) -> None:
        self.responses: list[str] = []
        self.outcomes: list[str] = []
        self.body: list[str] = []
        self.conditions: list[str] = []
        self.feedback: list[str] = []


def _content(asked: Asked, left_out: LeftOut) -> _Content | None:
    expected, content = asked.expected, _Content()
    if is_numeric(expected):
        found = numbers(asked, left_out)
        for i, one in enumerate(found):
            response = "RESPONSE" if len(found) == 1 else f"RESPONSE_{i + 1}"
            _number(content, response, one, expected.points / len(found), shown_unit(expected))
        return content if found else None
    if expected.kind == "word":
        _word(content, one_line(expected.text), expected.points)
        return content
    left_out.tell(f"{asked.place}: QTI has no interaction for a formula", asked.variant)
    return None


def _number(content: _Content, response: str, found: Number, points: float, unit: str) -> None:
    told = f"FEEDBACK_{response}"
    content.responses.append(_response(response, "float", number(found.right.value)))
    if found.mistakes:
        content.outcomes.append(
            element("outcomeDeclaration", identifier=told, cardinality="single", baseType="identifier")
        )
    field = element("textEntryInteraction", responseIdentifier=response, expectedLength="15")
    label = f"{html(found.label)}: " if found.label else ""
    content.body.append(f"<p>{label}{field}{f' {html(unit)}' if unit else ''}</p>")
    branches = [(_within(response, i), _scored(points)) for i in (found.right, *found.turned)]
    for i, mistake in enumerate(found.mistakes, start=1):
        branches.append((_within(response, mistake), _set(told, "identifier", f"mistake_{i}")))
        content.feedback.append(_feedback(told, f"mistake_{i}", f"<p>{html(mistake.feedback)}</p>"))
    content.conditions.append(_condition(branches))


def _word(content: _Content, word: str, points: float) -> None:
    choices = alternatives(word)
    if choices:
        due = word.lower()
        content.responses.append(_response("RESPONSE", "identifier", f"choice_{due}"))
        options = (element("simpleChoice", html(c), identifier=f"choice_{c}") for c in choices)
        shape = {"responseIdentifier": "RESPONSE", "shuffle": "false", "maxChoices": "1"}
        content.body.append(element("choiceInteraction", *options, **shape))
        test = element("match", element("variable", identifier="RESPONSE"), element("correct", identifier="RESPONSE"))
    else:
        content.responses.append(_response("RESPONSE", "string", word))
        content.body.append(f"<p>{element('textEntryInteraction', responseIdentifier='RESPONSE')}</p>")
        sides = element("variable", identifier="RESPONSE") + element("correct", identifier="RESPONSE")
        test = element("stringMatch", sides, caseSensitive="false")
    content.conditions.append(_condition([(test, _scored(points))]))


def _item(name: str, asked: Asked, content: _Content, figure: Figure | None) -> str:
    task, expected = asked.task, asked.expected
    solution = task.worked.get("mathjax", "")
    score = element("defaultValue", element("value", "0"))
    shape = {"identifier": SCORE, "cardinality": "single", "baseType": "float", "normalMinimum": "0"}
    outcomes = [element("outcomeDeclaration", score, **shape, normalMaximum=number(expected.points)), *content.outcomes]
    conditions, feedback = list(content.conditions), list(content.feedback)
    if solution:
        outcomes.append(
            element("outcomeDeclaration", identifier="SOLUTION", cardinality="single", baseType="identifier")
        )
        conditions.append(_set("SOLUTION", "identifier", "worked"))
        feedback.append(_feedback("SOLUTION", "worked", solution))
    asks = f"<p>{html(question_of(expected))}</p>"
    # A figure lies beside its item.
    shown = figure.shown(f"{name}{SUFFIX}") if figure is not None else ""
    body = paragraphs(text_of(task)) + shown + bullets(task.given) + asks + "".join(content.body)
    head = {"xmlns": ITEMS, "xmlns:xsi": INSTANCE, "xsi:schemaLocation": WHERE_ITEMS, "identifier": f"item-{name}"}
    return DECLARATION + element(
        "assessmentItem",
        *content.responses,
        *outcomes,
        element("itemBody", body),
        element("responseProcessing", *conditions),
        *feedback,
        **head,
        title=name_of(task, expected.find, asked.variant, LONGEST_TITLE),
        adaptive="false",
        timeDependent="false",
    )


def _response(identifier: str, base: str, due: str) -> str:
    correct = element("correctResponse", element("value", xml(due)))
    return element("responseDeclaration", correct, identifier=identifier, cardinality="single", baseType=base)


def _within(response: str, interval: Interval) -> str:
    """Is the response in an interval?"""
    value = element("baseValue", number(interval.value), baseType="float")
    reach = number(interval.tolerance)
    shape = {"toleranceMode": "absolute", "tolerance": f"{reach} {reach}"}
    bounds = {"includeLowerBound": "true", "includeUpperBound": "true"}
    return element("equal", element("variable", identifier=response), value, **shape, **bounds)


def _condition(branches: Sequence[tuple[str, str]]) -> str:
    """The first branch whose test holds."""
    first, *others = branches
    then = (element("responseElseIf", *branch) for branch in others)
    return element("responseCondition", element("responseIf", *first), *then)


def _scored(points: float) -> str:
    """More points."""
    more = element("baseValue", number(points), baseType="float")
    return element("setOutcomeValue", element("sum", element("variable", identifier=SCORE), more), identifier=SCORE)


def _set(outcome: str, base: str, value: str) -> str:
    return element("setOutcomeValue", element("baseValue", value, baseType=base), identifier=outcome)


def _feedback(outcome: str, identifier: str, content: str) -> str:
    return element("modalFeedback", content, outcomeIdentifier=outcome, identifier=identifier, showHide="show")


def _manifest(title: str, seed: int, names: Sequence[str], drawn: Collection[str]) -> str:
    """`drawn`: the items that have figures."""
    resources = (
        element(
            "resource",
            *(element("file", href=f"items/{name}{end}") for end in (".xml", *([SUFFIX] if name in drawn else []))),
            identifier=f"resource-{name}",
            type=ITEM_TYPE,
            href=f"items/{name}.xml",
        )
        for name in names
    )
    about = element("metadata", element("schema", "QTIv2.1 Package"), element("schemaversion", "1.0.0"))
    head = {"xmlns": PACKAGE, "xmlns:xsi": INSTANCE, "xsi:schemaLocation": WHERE_PACKAGE}
    return DECLARATION + element(
        "manifest",
        about,
        element("organizations"),
        element("resources", *resources),
        **head,
        identifier=f"manifest-{slug(title)}-{seed}",
    )


def _zipped(files: Mapping[str, bytes]) -> bytes:
    """An archive that is the same for the same files: sorted, without times; the manifest first, as readers like it."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        for name in sorted(files, key=lambda n: ("/" in n, n)):
            member = zipfile.ZipInfo(name, NEVER)
            member.compress_type = zipfile.ZIP_DEFLATED
            member.external_attr = 0o644 << 16
            # Else it would tell on which system it was made.
            member.create_system = 3
            archive.writestr(member, files[name])
    return out.getvalue()
