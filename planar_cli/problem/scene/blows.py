"""Facts of joints in a blow: impulses instead of forces, velocities just after it instead of accelerations.

A blow takes no time, so that finite forces (weight, springs, friction of a fixed size) have no impulse. Velocities just
after it obey what accelerations obey at rest: the same rows, with the rates of the joints in their place.
"""

from __future__ import annotations

from dataclasses import replace

from planar_cli.problem.scene.facts import Facts, Joining, Law, Mode, Row, Test


def in_a_blow(mode: Mode) -> Mode:
    """The same mode of a joint during a blow."""
    sliding = None if mode.sliding is None else _row(mode.sliding)
    tests = tuple(_test(t) for t in mode.tests)
    return replace(mode, facts=_facts(mode.facts), tests=tests, sliding=sliding, touching=Facts())


def _facts(facts: Facts) -> Facts:
    return replace(
        facts,
        joinings=tuple(_joining(j) for j in facts.joinings),
        rows=tuple(_row(r) for r in facts.rows),
        laws=tuple(_law(law) for law in facts.laws),
        skids=(),
    )


def _row(row: Row) -> Row:
    return replace(row, rate=0, pace=row.rate, sharpening=0)


def _joining(joining: Joining) -> Joining:
    return replace(joining, drift=None, pace=joining.drift)


def _law(law: Law) -> Law:
    """A force of a fixed size has no impulse."""
    return law if law.of is not None else replace(law, factor=0)


def _test(test: Test) -> Test:
    row = None if test.row is None else _row(test.row)
    joining = None if test.joining is None else _joining(test.joining)
    # A slip that just ends counts as well: full friction does not contradict it.
    return replace(test, row=row, joining=joining, constant=0, strict=test.strict and row is None)
