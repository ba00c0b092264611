"""The numbers of variants are those of the same file solved with their values, and no mistake gives a right one."""

from __future__ import annotations

import math
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from conftest import ROOT
from homework_made import set_of, with_known_mistakes

from planar_cli.homework.grading.carried_errors import Carrier
from planar_cli.homework.homework import prepared
from planar_cli.homework.sets.powers_of_ten import OFF_BY_TEN
from planar_cli.homework.sets.ready import Prepared
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.variants.course import course_of
from planar_cli.homework.variants.fit_variants import in_equations
from planar_cli.homework.variants.solved_anew import to_check
from planar_cli.homework.variants.tolerance_report import tolerance_report
from planar_cli.homework.variants.variant_draws import Draw
from planar_cli.homework.variants.variants import Variant, columns, variations
from planar_cli.homework.variants.worked_problem import (
    Carried,
    WorkedProblem,
    base_expected,
    models_of,
    read_and_solve,
    with_numbers,
)
from planar_cli.replay.equations import Asked, Equations, Step
from planar_cli.replay.numbers import Replay
from planar_cli.replay.single import NoNumber, Single


def ready(folder: Path, text: str, number: int) -> tuple[WorkedProblem, Prepared]:
    """A problem and its variants."""
    (problem,) = set_of(folder, f"variants: {{number: {number}, seed: 5}}", p=text).problems
    return read_and_solve(problem.path, "p"), prepared(problem, number, 5)


def assert_solved_anew_the_same(worked: WorkedProblem, made: Prepared) -> None:
    for values, task in zip(made.values, made.tasks, strict=True):
        anew = {e.find: e for e in base_expected(with_numbers(worked, dict(values)))}
        for one in task.expected:
            assert one.values == pytest.approx(anew[one.find].values, rel=1e-7), (values, one.find)
            assert one.text == anew[one.find].text


HARDER = """
plane: horizontal
given: {m: {from: 40 kg, to: 60 kg, step: 5 kg}, P: {one_of: [100 N, 200 N, 300 N]}}
points: {A: [0, 0]}
bodies: {crate: {particle: A, mass: m}}
loads:
  - force: {body: crate, magnitude: P, angle: 20 deg}
instant: [at rest]
find: {a: a(crate).x}
cases:
  strong:
    given: {P: 300 N}
    find: {a_strong: a(crate).x}
"""


def test_what_a_case_gives_itself_does_not_vary_there(tmp_path: Path) -> None:
    """a = P cos 20° / m with 300 N in each variant, also where the file's own value is that of the case."""
    worked, made = ready(tmp_path, HARDER, 8)
    assert_solved_anew_the_same(worked, made)
    assert made.taken == 8
    again, same = ready(tmp_path, HARDER.replace("given: {P: 300", "given: {P: 100"), 8)
    assert_solved_anew_the_same(again, same)


ROUGH = """
plane: vertical
given: {m: 40 kg, P: {one_of: [100 N, 200 N]}}
points: {A: [0, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {crate: {particle: A, mass: m}}
joints:
  - contact: {between: [crate, floor], at: A, mu: 0.1}
loads:
  - force: {body: crate, magnitude: P, angle: 20 deg}
instant: [v(crate).x = 1 m/s]
find: {a: a(crate).x}
cases:
  strong:
    given: {P: 300 N}
    find: {N: reaction(A).y, a_strong: a(crate).x}
"""


def test_an_own_error_is_carried_with_what_the_case_gives(tmp_path: Path) -> None:
    """a = (P cos 20° - 0.1 N) / m with 300 N and the own N, in each variant."""
    _, made = ready(tmp_path, ROUGH, 2)
    carrier = Carrier({"p": pickle.loads(made.carrying)})
    for k, task in enumerate(made.tasks):
        one = next(e for e in task.expected if e.find == "a_strong")
        due = carrier.for_variant(k)(task, one, {"N": (392.4,)})
        assert due is not None
        assert due[0] == pytest.approx([(300 * math.cos(math.radians(20)) - 39.24) / 40])


ROLLS = """
plane: vertical
given: {m: 4 kg, R: 0.2 m, beta: {one_of: [20 deg, 24 deg, 55 deg]}, mu: 0.2, d: 5 m}
coordinates: {s: m}
points: {O: [0, 0], C: {from: O, distance: s, angle: -beta}, G: {from: C, distance: R, angle: 90 deg - beta}}
surfaces: {slope: {through: O, angle: -beta}}
bodies: {cyl: {disk: G, radius: R, mass: m}}
joints:
  - contact: {between: [cyl, slope], at: C, mu: mu}
states:
  0: [s = 0, at rest, t = 0]
  1: [s = d]
find: {v: v(G).mag @ 1, omega: omega(cyl) @ 1}
"""


@pytest.mark.slow
def test_a_variant_of_a_motion_has_the_modes_of_the_file(tmp_path: Path) -> None:
    """At 55° the cylinder slips, as tan 55° > 3 mu."""
    worked, made = ready(tmp_path, ROLLS, 3)
    assert {dict(v)["beta"] for v in made.values[1:]} == {"20 deg", "24 deg"}
    assert_solved_anew_the_same(worked, made)


def test_each_value_is_solved_anew_where_few_variants_are_enough(tmp_path: Path) -> None:
    worked, _ = ready(tmp_path, HARDER, 1)
    drawn = [Draw((("m", f"{m} kg"), ("P", f"{p} N"))) for m in (40, 45, 50, 55, 60) for p in (100, 200, 300)]
    checked = [dict(drawn[k].values) for k in to_check(worked, drawn)]
    assert {d["m"] for d in checked} >= {"45 kg", "50 kg", "55 kg", "60 kg"}
    assert {d["P"] for d in checked} >= {"200 N", "300 N"}
    assert len(checked) <= 5
    many = [Draw((("m", f"{m} kg"), ("P", f"{m + 60} N"))) for m in range(40, 100)]
    assert {dict(many[k].values)["m"] for k in to_check(worked, many)} == {"40 kg", "99 kg"}


FOUR_BAR = """
given: {l_AB: {one_of: [0.2 m, 0.25 m]}, l_BC: 0.5 m, l_DC: 0.4 m, d: 0.6 m, w: {one_of: [8 rad/s, 10 rad/s]}}
points:
  A: [0, 0]
  D: [d, 0]
  B: {from: A, distance: l_AB, angle: 60 deg}
  C: {distances: {B: l_BC, D: l_DC}, side: above}
bodies: {AB: {rod: [A, B]}, BC: {rod: [B, C]}, DC: {rod: [D, C]}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: B, between: [AB, BC]}
  - pin: {at: C, between: [BC, DC]}
  - pin: {at: D, between: [ground, DC]}
motion: [omega(AB) = -w]
find: {omega_BC: omega(BC), alpha_BC: alpha(BC), alpha_DC: alpha(DC)}
"""


def test_places_that_rest_on_what_varies_stay_in_letters(tmp_path: Path) -> None:
    """C is where two circles meet, another point with another crank; no equation has a part twice."""
    worked, made = ready(tmp_path, FOUR_BAR, 4)
    assert made.taken == 4
    assert not any("one by one" in w for w in made.warnings)
    assert_solved_anew_the_same(worked, made)
    mistakes = {m.name for e in made.tasks[0].expected if e.find == "alpha_BC" for m in e.mistakes}
    assert "centripetal-left-out" in mistakes
    assert "tangential-left-out" not in mistakes


def test_wrong_equations_make_no_mistakes_and_carry_nothing(tmp_path: Path) -> None:
    """Equations in which a length of the file was put in: where they do not give the answer, they tell nothing."""
    worked, made = ready(tmp_path, ROUGH, 1)
    data = pickle.loads(made.carrying)
    (part,) = (p for p in worked.parts if p.solution.case == "")
    assert part.replay is not None
    weight = part.replay.equations.inputs["g"]
    folded = part.replay.equations.mapped(
        replace(s, residuals=tuple(r.xreplace({weight: 5}) for r in s.residuals)) for s in part.replay.equations.steps
    )
    broken = replace(part, replay=Replay(folded))
    worked.parts = (broken, *worked.parts[1:])
    row = with_known_mistakes(worked)
    models = {name for name, _ in models_of(worked)}
    # That the number itself is off by a power of ten rests on no equation.
    assert not models.intersection(m.name for m in row[0].mistakes if m.feedback != OFF_BY_TEN)
    assert models.intersection(m.name for m in row[-1].mistakes)
    task, (_, _, one) = made.tasks[0], made.tasks[0].expected
    strong = data.equations["strong"]
    wrong = replace(data, equations={**data.equations, "strong": replace(folded, asked=strong.asked, case="strong")})
    assert Carrier({"p": data}).for_variant(0)(task, one, {"N": (300.0,)}) is not None
    assert Carrier({"p": wrong}).for_variant(0)(task, one, {"N": (300.0,)}) is None


LEDGE = """
plane: vertical
given: {v_0: {one_of: [11 m/s, 25 m/s, 40 m/s]}, h: 5 m}
bodies: {s: {particle: [0, 0], mass: any}}
states:
  0: [v(s).y = v_0, v(s).x = 0, t = 0]
  top: [v(s).y = 0]
  1: [y(s) = h]
find: {t: t @ 1}
"""
SPRING = """
plane: vertical
given: {W: {one_of: [10 lbf, 30 lbf]}, beta: 25 deg, d: {one_of: [24 in, 42 in, 48 in]}, k: 20 lbf/in, mu: 0.2}
coordinates: {s: ft}
points: {O: [0, 0], P: {from: O, distance: s, angle: -beta}, S: {from: O, distance: d + 3 ft, angle: -beta}}
surfaces: {slope: {through: O, angle: -beta}}
bodies: {block: {particle: P, weight: W}}
joints:
  - contact: {between: [block, slope], mu: mu}
loads:
  - spring: {between: [P, S], stiffness: k, natural_length: 3 ft, acts: push, name: sp}
states:
  0: [s = 0, at rest]
  1: [s = d]
  2: [at rest]
find: {c: s @ 2 - d in in, F: force(sp).mag @ 2}
"""


@pytest.mark.parametrize(("text", "number"), [(LEDGE, 3), pytest.param(SPRING, 6, marks=pytest.mark.slow)])
def test_a_root_stays_on_its_branch(text: str, number: int, tmp_path: Path) -> None:
    """The stone on its way down, the spring compressed, however far from the values of the file."""
    worked, made = ready(tmp_path, text, number)
    assert made.taken == number
    assert not any("one by one" in w for w in made.warnings)
    assert_solved_anew_the_same(worked, made)


@pytest.mark.slow
def test_a_mistake_stays_on_the_branch_of_the_answer(tmp_path: Path) -> None:
    """d = 24 in put in as 24 ft compresses the spring more, not less than nothing."""
    _, made = ready(tmp_path, SPRING, 1)
    (c, _) = made.tasks[0].expected
    wrong = [m.values[0] for m in c.mistakes if m.name == "given-not-converted" and "d was" in m.feedback]
    assert wrong == pytest.approx([8.458861254], rel=1e-6)


def test_what_is_of_no_second_degree_is_followed() -> None:
    """x³ - 3 x + c from the root in the middle, whose slope is negative, and beyond the fold no root."""
    x, c = sp.symbols("x c", real=True)
    equations = Equations(
        "", {"c": c}, {}, (Step((x,), (x**3 - 3 * x + c,)),), {"x": Asked((x,))}, (), {c: 0.0, x: 0.0}
    )
    replay = Replay(equations)
    values = np.array([0.5, 1.9, 2.5])
    (found,) = replay.run({c: values}).asked("x")
    assert found[:2] ** 3 - 3 * found[:2] == pytest.approx(-values[:2])
    assert (np.abs(found[:2]) < 1).all()
    assert np.isnan(found[2])
    single = Single(replay)
    assert single.run({c: 1.9}, {}, {c: 0.0, x: 0.0})[x] == pytest.approx(found[1])
    with pytest.raises(NoNumber):
        single.run({c: 2.5}, {}, {c: 0.0, x: 0.0})


SET = sorted(p for p in (ROOT / "tests" / "homework").glob("*.yaml") if "problems:" not in p.read_text())


LINKED = (
    HARDER
    + """
  first:
    find: {a_1: a(crate).x}
  linked:
    given: {Q: 2*first.a_1}
    find: {F: m*Q}
"""
)


def test_tolerances_of_variants_are_by_their_own_numbers(tmp_path: Path) -> None:
    """In a case with numbers of its own, behind a find of another case, and of a variant that was solved by itself."""
    worked, _ = ready(tmp_path, LINKED.replace("given: {m:", "given: {Q: 1 m/s^2, m:", 1), 1)
    drawn = [Draw((("m", f"{m} kg"), ("P", f"{p} N"))) for m, p in ((45, 100), (60, 300))]
    alone = [with_numbers(worked, dict(d.values)) for d in drawn]
    pairs = list(zip(drawn, alone, strict=True))
    variants = [Variant(d, base_expected(own)) for d, own in pairs]
    variants += [Variant(d, base_expected(own), own) for d, own in pairs]
    found, left = tolerance_report(worked, Rules(), variants)
    assert not left
    assert [row[0].find for row in found] == ["a", "a_strong", "a_1", "F"]
    assert all(danger.honest < 0.006 for row in found for danger in row)


RATIO = """
plane: vertical
given: {m: 20 kg, mu: 0.2, beta: 30 deg}
variants: {m: {from: 20 kg, to: 24 kg, step: 1 kg}, mu: [0.2, 0.22, 0.24]}
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: -beta}}
bodies: {block: {particle: A, mass: m}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu}
instant: [v(block).along(-beta) = 1 m/s]
find: {n: N(A)/(m*g), a: a(block).along(-beta)}
"""


def test_a_mistake_without_a_number_hinders_no_variant(tmp_path: Path) -> None:
    # Without the weight N/(m g) has no value.
    worked, made = ready(tmp_path, RATIO, 5)
    assert made.taken == 5
    assert tolerance_report(worked, Rules())[0]


def of_each_value(path: Path, pick: slice) -> None:
    worked = read_and_solve(str(path), "p")
    for varied in variations(worked):
        drawn = [Draw(((varied.name, value),)) for value in varied.values[pick]]
        numbers = Carried(worked, columns(worked, drawn))
        for k, one in enumerate(drawn):
            anew = with_numbers(worked, dict(one.values))
            if course_of(anew.solution) != course_of(worked.solution):
                continue
            due = {e.find: e.values for e in base_expected(anew)}
            for part, find in in_equations(worked):
                here = [float(n[k]) for n in numbers.asked(part, find)]
                assert here == pytest.approx(due[find.name], rel=1e-7, abs=1e-12), (one.values, find.name)
    right = {e.find: e.values for e in base_expected(worked)}
    row = with_known_mistakes(worked)
    for one in row:
        assert all(m.values != pytest.approx(right[one.find], rel=1e-6) for m in (*one.mistakes, *one.nearly))


@pytest.mark.parametrize("path", SET, ids=lambda p: p.stem)
def test_the_last_value_of_each_name_is_that_of_the_file_solved_with_it(path: Path) -> None:
    of_each_value(path, slice(-1, None))


@pytest.mark.slow
@pytest.mark.parametrize("path", SET, ids=lambda p: p.stem)
def test_each_value_of_each_name_is_that_of_the_file_solved_with_it(path: Path) -> None:
    of_each_value(path, slice(None))
