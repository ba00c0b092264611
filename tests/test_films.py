"""Films of motions: they play without script, keep rigid what is rigid, and show what was followed."""

from __future__ import annotations

import math
import re
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from conftest import ROOT
from test_graphs import path_of

from planar_cli import cli
from planar_cli.figures.frames import film
from planar_cli.formats._animated import animated, page
from planar_cli.homework.checking.checking import read
from planar_cli.report.document.film import Film
from planar_cli.report.document.marks import Coil, Hatched, Polyline, Slot, Symbol
from planar_cli.simulate.run import Settings, follow

SPACE = "{http://www.w3.org/2000/svg}"
STEMS = ("double-pendulum-let-go-level", "block-that-sticks-and-slips", "ball-that-comes-to-rest", "body-spiral-cam")


def film_of(stem: str) -> Film:
    return film(follow(read(str(path_of(stem))), Settings()))


def animations(root: ET.Element) -> list[ET.Element]:
    return [e for e in root.iter() if e.tag.startswith(f"{SPACE}animate")]


@pytest.mark.parametrize("stem", STEMS)
def test_a_film_plays_by_itself(stem: str) -> None:
    shown = film_of(stem)
    text = animated(shown)
    root = ET.fromstring(text)
    assert "script" not in text
    assert "http" not in text.replace("http://www.w3.org/2000/svg", "")
    found = animations(root)
    assert found
    for element in found:
        values, keys = (element.attrib[k].split(";") for k in ("values", "keyTimes"))
        times = [float(k) for k in keys]
        assert len(values) == len(times)
        assert (times[0], times[-1]) == (0.0, 1.0)
        assert times == sorted(times)
        assert element.attrib["repeatCount"] == "indefinite"
    assert len({element.attrib["dur"] for element in found}) == 1
    assert animated(shown) == text


def test_a_page_of_it_forbids_everything_else() -> None:
    text = page(film_of("ball-that-comes-to-rest"))
    assert "default-src &#x27;none&#x27;" in text
    assert "<script" not in text
    assert "<animateTransform" in text


def test_rods_keep_their_length_and_end_where_they_were_followed() -> None:
    run = follow(read(str(path_of("double-pendulum-let-go-level"))), Settings())
    shown = film(run)
    rods = [t for t in shown.things if all(isinstance(m, Polyline) for m in t.shots[0])]
    assert len(rods) == 2
    for rod in rods:
        lengths = [math.dist(*m.places) for marks in rod.shots for m in marks if isinstance(m, Polyline)]
        assert max(lengths) - min(lengths) < 1e-9
    points = [t.shots[-1][0] for t in shown.things if isinstance(t.shots[0][0], Symbol) and len(t.shots[0]) == 2]
    ends = [
        m.at for rod in rods for m in rod.shots[-1] if isinstance(m, Polyline) for m in [Symbol("point", m.places[1])]
    ]
    places = [p.at for p in points if isinstance(p, Symbol)]
    assert all(min(math.dist(end, p) for p in places) < 1e-9 for end in ends)


def test_a_spring_keeps_its_turns_and_the_ground_its_place() -> None:
    shown = film_of("block-that-sticks-and-slips")
    coils = [m for t in shown.things for marks in t.shots for m in marks if isinstance(m, Coil)]
    assert len({m.like for m in coils}) == 1
    assert len({m.end for m in coils}) > 10
    floors = (t.shots for t in film_of("ball-that-comes-to-rest").things if t.shots[0])
    assert [len(set(shots)) for shots in floors if isinstance(shots[0][0], Hatched)] == [1]


def test_its_speed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """In real time where that can be seen; half as fast where that is wanted."""
    target = tmp_path / "m.svg"
    for more, words in ((("--speed", "0.5"), "2 × slower"), ((), "t in s")):
        assert cli.run(["simulate", str(path_of("ball-that-comes-to-rest")), "--animate", str(target), *more]) == 0
        assert words in re.sub(r"<[^>]*>", "", target.read_text(encoding="utf-8")).replace("\n", "")
    capsys.readouterr()


@pytest.mark.parametrize(
    "args",
    [["--animate", "m.png"], ["--speed", "2"], ["--animate", "m.svg", str(ROOT / "problems/hard/comet.yaml")]],
)
def test_what_no_film_can_come_of_is_refused(args: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["simulate", str(path_of("ball-that-comes-to-rest")), *args]) == 2
    assert capsys.readouterr().err


HOSTILE = 'title: "<script>alert(1)</script> ]]> & $x$"\n'


def test_words_of_a_file_do_nothing(tmp_path: Path) -> None:
    text = path_of("ball-that-comes-to-rest").read_text(encoding="utf-8")
    path = tmp_path / "hostile.yaml"
    path.write_text(HOSTILE + text.partition("\n")[2], encoding="utf-8")
    for kind, ending in (("--animate", "svg"), ("--animate", "html"), ("--plot", "svg")):
        target = tmp_path / f"m{kind}.{ending}"
        assert cli.run(["simulate", str(path), kind, str(target)]) == 0
        made = target.read_text(encoding="utf-8")
        assert "<script" not in made


def test_ropes_of_one_direction_stay_parallel() -> None:
    shots = [marks for thing in film_of("load-on-four-strands").things for marks in thing.shots]
    ropes = [m.places for marks in shots for m in marks if isinstance(m, Polyline) and m.style == "rope"]
    assert len(ropes) > 5
    assert all(abs(start[0] - end[0]) < 1e-6 for start, end in ropes)


def test_loads_on_a_rope_over_a_pulley_are_blocks_in_a_film_too() -> None:
    shots = [m for t in film_of("winch-with-counterweight").things for m in t.shots[0]]
    blocks = [m for m in shots if isinstance(m, Symbol) and m.kind == "block"]
    assert [math.cos(block.angle) for block in blocks] == [pytest.approx(-1.0)] * 2


def test_a_guide_that_holds_nothing_is_in_no_film_and_springs_lie_side_by_side() -> None:
    marks = [m for thing in film_of("weight-dropped-on-nested-springs").things for m in thing.shots[0]]
    assert not [m for m in marks if isinstance(m, Slot) or (isinstance(m, Symbol) and m.kind == "slider")]
    assert [m.at for m in marks if isinstance(m, Symbol) and m.kind == "block"]
    one, other = (m.lane for m in marks if isinstance(m, Coil))
    assert one == -other != 0
