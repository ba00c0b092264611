"""QTI 2.1: items that a small interpreter of response processing scores, in a package as importers want it."""

from __future__ import annotations

import io
import re
import xml.etree.ElementTree as ET
import zipfile
from functools import cache

import pytest
from exported import HOSTILE, PAPERS, exported

from planar_cli.homework.exports._text import one_line
from planar_cli.homework.exports.qti import INSTANCE, ITEMS, PACKAGE

Q, P = f"{{{ITEMS}}}", f"{{{PACKAGE}}}"
NCNAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]*")
BLOCKS = {"p", "ul", "h3", "h4", "h5", "h6", "table", "choiceInteraction"}
ORDER = ("responseDeclaration", "outcomeDeclaration", "itemBody", "responseProcessing", "modalFeedback")


@cache
def package() -> dict[str, ET.Element]:
    (content,) = exported("qti").files.values()
    archive = zipfile.ZipFile(io.BytesIO(content))
    return {name: ET.fromstring(archive.read(name)) for name in archive.namelist()}


def items() -> dict[str, ET.Element]:
    return {name: root for name, root in package().items() if name.startswith("items/") and name.endswith(".xml")}


def test_an_item_shows_the_figure_of_its_sheet() -> None:
    """It lies beside the item, and the manifest lists it with it."""
    listed = {f.get("href") for f in package()["imsmanifest.xml"].iter(f"{P}file")}
    assert listed == package().keys() - {"imsmanifest.xml"}
    for name, root in items().items():
        called = [image.attrib for image in root.iter(f"{Q}img")]
        figure = name.replace(".xml", ".svg")
        assert [f"items/{a['src']}" for a in called] == [figure] * (figure in package())
        assert all(a["alt"] == one_line(HOSTILE) for a in called)
    assert sum(n.endswith(".svg") for n in listed if n) == 6 * 3


def item(name: str) -> ET.Element:
    return package()[f"items/{name}.xml"]


class Session:
    """What becomes of the outcomes of an item when responses are given."""

    def __init__(self, root: ET.Element, responses: dict[str, str]) -> None:
        self.root, self.responses = root, responses
        self.bases = {d.get("identifier"): d.get("baseType") for d in root.findall(f"{Q}responseDeclaration")}
        self.outcomes: dict[str, str | float] = {}
        for declared in root.findall(f"{Q}outcomeDeclaration"):
            default = declared.findtext(f"{Q}defaultValue/{Q}value")
            if default is not None:
                self.outcomes[declared.attrib["identifier"]] = float(default)
        processing = root.find(f"{Q}responseProcessing")
        assert processing is not None
        for rule in processing:
            self.rule(rule)

    def rule(self, rule: ET.Element) -> None:
        if rule.tag == f"{Q}setOutcomeValue":
            value = self.value(rule[0])
            assert value is not None
            self.outcomes[rule.attrib["identifier"]] = value
            return
        assert rule.tag == f"{Q}responseCondition"
        for branch in rule:
            if self.value(branch[0]):
                for inner in branch[1:]:
                    self.rule(inner)
                return

    def value(self, of: ET.Element) -> str | float | bool | None:
        parts = [self.value(e) for e in of]
        match of.tag.removeprefix(Q):
            case "baseValue":
                return float(of.text or "") if of.get("baseType") == "float" else of.text
            case "variable":
                return self.variable(of.attrib["identifier"])
            case "correct":
                path = f"{Q}responseDeclaration[@identifier='{of.get('identifier')}']/{Q}correctResponse/{Q}value"
                return self.root.findtext(path)
            case "sum":
                return sum(float(p) for p in parts if p is not None)
            case "equal":
                low, high = map(float, of.attrib["tolerance"].split())
                assert of.get("toleranceMode") == "absolute"
                response, due = parts
                return response is not None and float(due or 0) - low <= float(response) <= float(due or 0) + high
            case "match":
                return parts[0] == parts[1]
            case "stringMatch":
                return parts[0] is not None and str(parts[0]).lower() == str(parts[1]).lower()
        raise AssertionError(of.tag)

    def variable(self, name: str) -> str | float | None:
        if name in self.outcomes:
            return self.outcomes[name]
        given = self.responses.get(name)
        return float(given) if given is not None and self.bases[name] == "float" else given

    @property
    def feedback(self) -> list[str]:
        """What is shown after answering, without the worked solution."""
        told = [(self.outcomes.get(f.attrib["outcomeIdentifier"]), f) for f in self.root.findall(f"{Q}modalFeedback")]
        shown = [f for outcome, f in told if outcome == f.get("identifier") and outcome != "worked"]
        return ["".join(f.itertext()) for f in shown]


def score(name: str, *responses: str) -> Session:
    names = ["RESPONSE"] if len(responses) == 1 else [f"RESPONSE_{i + 1}" for i in range(len(responses))]
    return Session(item(name), dict(zip(names, responses, strict=True)))


def test_the_manifest_lists_every_item() -> None:
    (content,) = exported("qti").files.values()
    assert zipfile.ZipFile(io.BytesIO(content)).namelist()[0] == "imsmanifest.xml"
    manifest = package()["imsmanifest.xml"]
    assert manifest.tag == f"{P}manifest"
    assert [e.tag for e in manifest] == [f"{P}metadata", f"{P}organizations", f"{P}resources"]
    resources = manifest.findall(f"{P}resources/{P}resource")
    assert {r.get("type") for r in resources} == {"imsqti_item_xmlv2p1"}
    assert [r.get("href") for r in resources] == [r.findall(f"{P}file")[0].get("href") for r in resources]
    ids = [manifest.get("identifier", ""), *(r.get("identifier", "") for r in resources)]
    assert len(set(ids)) == len(ids)
    assert all(NCNAME.fullmatch(i) for i in ids)


def test_one_item_for_each_find_and_variant() -> None:
    # Two formulas are left out.
    assert len(items()) == 10 * len(PAPERS)


@pytest.mark.parametrize("name", sorted(items()))
def test_items_are_built_as_the_schema_has_it(name: str) -> None:
    root = items()[name]
    assert root.tag == f"{Q}assessmentItem"
    assert NCNAME.fullmatch(root.get("identifier", ""))
    assert root.get("title")
    assert (root.get("adaptive"), root.get("timeDependent")) == ("false", "false")
    assert f"{{{INSTANCE}}}schemaLocation" in root.attrib
    kinds = [e.tag.removeprefix(Q) for e in root]
    assert kinds == sorted(kinds, key=ORDER.index)
    body = root.find(f"{Q}itemBody")
    assert body is not None
    assert {e.tag.removeprefix(Q) for e in body} <= BLOCKS
    declared = {d.get("identifier") for d in root.findall(f"{Q}responseDeclaration")}
    asked = {e.get("responseIdentifier") for e in body.iter() if "responseIdentifier" in e.attrib}
    assert declared == asked
    outcomes = {d.get("identifier") for d in root.findall(f"{Q}outcomeDeclaration")}
    assert {f.get("outcomeIdentifier") for f in root.findall(f"{Q}modalFeedback")} <= outcomes
    assert {s.get("identifier") for s in root.iter(f"{Q}setOutcomeValue")} <= outcomes
    assert not {"script", "a"} & {e.tag.removeprefix(Q) for e in root.iter()}


@pytest.mark.parametrize("name", sorted(items()))
def test_the_correct_response_scores_all_points(name: str) -> None:
    root = items()[name]
    due = {
        d.attrib["identifier"]: d.findtext(f"{Q}correctResponse/{Q}value", "")
        for d in root.findall(f"{Q}responseDeclaration")
    }
    session = Session(root, due)
    declared = root.find(f"{Q}outcomeDeclaration[@identifier='SCORE']")
    assert declared is not None
    assert session.outcomes["SCORE"] == pytest.approx(float(declared.get("normalMaximum", "")))
    assert not session.feedback


@pytest.mark.parametrize(("typed", "points"), [("3.2", 2), ("3.23", 2), ("3.24", 0), ("-3.2", 0)])
def test_a_number(typed: str, points: float) -> None:
    assert score("slider-a_a-v0", typed).outcomes["SCORE"] == points


def test_no_answer_scores_nothing() -> None:
    session = Session(item("slider-a_a-v0"), {})
    assert session.outcomes["SCORE"] == 0
    assert not session.feedback


def test_a_mistake_shows_its_feedback() -> None:
    session = score("slider-a_a-v0", "-2.0")
    assert session.outcomes["SCORE"] == 0
    assert session.feedback == ["Friction acts the other way."]


@pytest.mark.parametrize("typed", ["350", "-10", "710"])
def test_a_direction_is_right_after_a_turn(typed: str) -> None:
    assert score("slider-theta-v0", typed).outcomes["SCORE"] == 1


def test_a_vector_has_two_fields_that_share_the_points() -> None:
    assert score("linkage-v_b-v0", "3", "0").outcomes["SCORE"] == 1
    half = score("linkage-v_b-v0", "3", "9")
    assert half.outcomes["SCORE"] == pytest.approx(0.5)
    assert half.feedback == ["The Coriolis term is missing."]


def test_words() -> None:
    assert score("linkage-slips-v0", "choice_yes").outcomes["SCORE"] == 1
    assert score("linkage-slips-v0", "choice_no").outcomes["SCORE"] == 0
    assert score("linkage-mode-v0", "STICKS*").outcomes["SCORE"] == 1


def test_the_worked_solution_is_shown_after_answering() -> None:
    root = item("slider-mu-v1")
    assert Session(root, {"RESPONSE": "9"}).outcomes["SOLUTION"] == "worked"
    shown = root.find(f"{Q}modalFeedback[@identifier='worked']")
    assert shown is not None
    assert r"\[a_{A} \lt 3.2~\mathrm{m/s^{2}} \tag{1}\]" in "".join(shown.itertext())


def test_the_unit_is_named() -> None:
    body = item("slider-a_a-v0").find(f"{Q}itemBody")
    assert body is not None
    assert "m/s²" in "".join(body.itertext())


def test_the_archive_has_no_clock() -> None:
    (content,) = exported("qti").files.values()
    assert {i.date_time for i in zipfile.ZipFile(io.BytesIO(content)).infolist()} == {(1980, 1, 1, 0, 0, 0)}
