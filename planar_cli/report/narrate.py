"""A solution as a document: effects, the three steps, answers, checks and what is worth discussing."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.report.blocks import (
    Answer,
    Block,
    Check,
    Document,
    Equation,
    Forces,
    Heading,
    Line,
    Math,
    Name,
    Note,
    Paragraph,
    Text,
    line,
)
from planar_cli.report.effects import effect_notes
from planar_cli.report.forces import force_rows
from planar_cli.report.words import Phrases, answer_line
from planar_cli.solve.algebra import Line as SolvedLine
from planar_cli.solve.algebra import SolvedBlock
from planar_cli.solve.solution import InstantSolution, PartSolution, Solution
from planar_cli.solve.stages import Stage
from planar_cli.solve.write import Explicit, Written


def narrate(solution: Solution, figures: int = 4, audience: str = "exam") -> Document:
    """The worked solution of a file. `audience`: exam (short) or lesson (with the text and every line)."""
    blocks: list[Block] = []
    problem = solution.problem
    if audience == "lesson" and problem.text:
        blocks.append(Paragraph(line(problem.text)))
    for part in solution.parts:
        if part.case:
            blocks.append(Heading("CASE", part.case.replace("_", " ")))
        blocks += Narrator(part, figures, audience).blocks()
    return Document(problem.title or problem.file, tuple(blocks))


class Narrator:
    """Tells one part of a solution."""

    def __init__(self, part: PartSolution, figures: int, audience: str) -> None:
        self.part, self.figures, self.audience = part, figures, audience

    def blocks(self) -> list[Block]:
        blocks: list[Block] = []
        for instant in self.part.instants:
            if instant.state:
                blocks.append(Heading("STATE", instant.state))
            blocks += Telling(instant, self.figures, self.audience).blocks()
        last = self.part.instants[-1]
        phrases = phrases_of(last, self.figures)
        for found in self.part.found:
            blocks.append(Answer(found.name, answer_line(found, phrases), ":" if found.word else "="))
        for instant in self.part.instants:
            blocks += check_blocks(instant, self.figures)
        return blocks


def phrases_of(instant: InstantSolution, figures: int) -> Phrases:
    """The phrases in which an instant speaks."""
    ledger = instant.instant.scene.ledger
    return Phrases(ledger, instant.value, figures, ledger.symbolic)


class Telling:
    """Tells one instant in three steps."""

    def __init__(self, instant: InstantSolution, figures: int, audience: str) -> None:
        self.instant, self.figures, self.audience = instant, figures, audience
        self.system = instant.trial.system
        self.scene = instant.instant.scene
        self.phrases = phrases_of(instant, figures)

    def blocks(self) -> list[Block]:
        blocks: list[Block] = list(effect_notes(self.instant))
        blocks += self._assumptions()
        kinematic = [s for s in self.instant.stages if s.level == "velocity"]
        last = next((s for s in self.instant.stages if s.level == "acceleration"), None)
        kinetic = last is not None and any(w.law != "relation" for b in last.blocks for w in b.equations)
        blocks.append(Heading("STEP 1", "Kinematic analysis"))
        blocks += self._definitions()
        blocks += self._kinematics(kinematic, last)
        if kinetic and last is not None:
            aside = "" if self._method == "newton" else "inertial forces added"
            blocks.append(Heading("STEP 2", "Kinetic analysis", aside or "free-body diagram = kinetic diagram"))
            blocks += force_rows(self.instant, last, self.phrases)
            blocks += self._equations([w for b in last.blocks for w in b.equations if w.law != "relation"], last)
        if last is not None and last.blocks:
            blocks.append(Heading("STEP 3", "Solving the equations", self._count(last)))
            blocks += self._solving(last)
        return blocks

    _method = "newton"

    # --- before step 1 -----------------------------------------------------------------------------------------------

    def _assumptions(self) -> list[Block]:
        """What the first assumption was, why it fails, and what is assumed instead."""
        blocks: list[Block] = []
        trial = self.instant.trial
        natural = next((t for t in self.instant.rejected if not any(t.choice)), None)
        words = [m.words for m in trial.system.modes.values() if m.words]
        if natural is not None and any(trial.choice):
            assumed = [m.words for m in natural.system.modes.values() if m.words]
            blocks.append(Note("Assume", line("; ".join(assumed))))
            blocks.append(Note("Fails", line(self._objection(natural))))
            blocks.append(Note("Instead", line("; ".join(words))))
        elif words:
            blocks.append(Note("Assume", line("; ".join(words))))
        return blocks

    def _objection(self, trial: Any) -> Line:
        if trial.tests:
            test, value = trial.tests[0]
            if value is None:
                return line(f"no distribution of the reactions satisfies: {test.words}")
            return line(f"{test.words}: it would not hold")
        return line({"velocities": "the velocities contradict it", "contradiction": "the equations contradict it"}.get(trial.objection, trial.objection))

    # --- step 1 ------------------------------------------------------------------------------------------------------

    def _definitions(self) -> list[Block]:
        """Named intermediates that the equations use: coordinates, masses, moments of inertia."""
        used: set[sp.Symbol] = set()
        for stage in self.instant.stages:
            for block in stage.blocks:
                for w in block.equations:
                    used |= w.residual.free_symbols
            for x in stage.lines:
                used |= x.expression.free_symbols
        ledger = self.scene.ledger
        wanted = set(used)
        for symbol in reversed(list(ledger.definitions)):
            if symbol in wanted:
                wanted |= ledger.definitions[symbol].free_symbols
        blocks: list[Block] = []
        for symbol, expr in ledger.definitions.items():
            if symbol in wanted and not (expr.is_number and ledger.titles[symbol].startswith("mass")):
                blocks.append(Equation(self._chain(symbol, expr, self.phrases.shown(symbol)), None, line(ledger.titles[symbol] + ":")))
        return blocks

    def _chain(self, symbol: sp.Symbol, expr: sp.Expr, value: Any) -> tuple[Any, ...]:
        """symbol = formula = numbers = value."""
        sides: list[Any] = [self.phrases.math(symbol)]
        if not expr.is_number:
            sides.append(self.phrases.math(expr))
            numbers = self.phrases.numbers(expr)
            if numbers is not None and not expr.is_Symbol:
                sides.append(numbers)
        if not self.phrases.symbolic:
            sides.append(value)
        elif expr.is_number:
            sides.append(self.phrases.math(expr))
        return tuple(sides)

    def _kinematics(self, stages: list[Stage], last: Stage | None) -> list[Block]:
        blocks: list[Block] = []
        if not any(self.instant.trial.velocities[0].values.values()) and self.instant.instant.at_rest:
            blocks.append(Paragraph(line("At rest: all velocities are zero.")))
        for stage in stages:
            written = [w for b in stage.blocks for w in b.equations]
            if written:
                blocks.append(Paragraph(line("Velocities:")))
                blocks += self._equations(written, stage)
                blocks += self._solving(stage)
        if last is not None:
            relations = [w for b in last.blocks for w in b.equations if w.law == "relation"]
            if relations and stages:
                blocks.append(Paragraph(line("Accelerations:")))
            blocks += self._equations(relations, last)
            blocks += [self._explicit(x) for x in last.lines]
            for zero in last.zero:
                if self.audience == "lesson":
                    blocks.append(Paragraph(line(self.phrases.math(zero), " = 0: nothing acts that way.")))
        return blocks

    def _explicit(self, x: Explicit) -> Block:
        return Equation((self.phrases.math(x.symbol), self.phrases.math(x.expression)), x.number, line(x.words + ":"))

    # --- equations ---------------------------------------------------------------------------------------------------

    def _equations(self, written: list[Written], stage: Stage) -> list[Block]:
        return [block for w in written for block in self._equation(w, stage)]

    def _equation(self, w: Written, stage: Stage) -> list[Block]:
        blocks: list[Block] = []
        lead: Line = ()
        if w.law == "relation":
            blocks.append(Paragraph(line(self._relation_words(w))))
        else:
            group = ", ".join(w.bodies)
            if w.law == "moment":
                lead = line("↺ ", Name(f"ΣM_{w.lead}"), ":")
                blocks.append(Paragraph(self._moment_words(w, group, stage)))
            else:
                arrow = {"x": "→ ", "y": "↑ "}.get(w.lead, "↗ ")
                lead = line(arrow, Name(f"ΣF_{w.lead}") if w.lead else Text("ΣF"), ":")
                words = f"{group}, {w.words}:" if not w.lead else f"{group}:"
                blocks.append(Paragraph(line(words)))
        return [*blocks, Equation((self.phrases.math(w.left), self.phrases.math(w.right)), w.number, lead)]

    def _relation_words(self, w: Written) -> str:
        if w.source == "given":
            return f"Given: {w.lead}"
        if w.source == "closure":
            joint = next((j for j in self.system.tree.closures if j.joint == w.lead), None)
            if joint is not None:
                base = "the ground" if joint.base == "ground" else joint.base
                return f"Point {joint.place} of {joint.mover} moves with {base}, {w.words}:"
        return f"{w.lead[:1].upper()}{w.lead[1:]}{', ' + w.words if w.words and w.source != 'row' else ''}:"

    def _moment_words(self, w: Written, group: str, stage: Stage) -> Line:
        centre = stage.centres.get(w.lead)
        if centre is None:
            return line(f"{group}, moments about ", Name(w.lead), ":")
        place, through = centre
        parts: list[Any] = [f"{group}, moments about ", Name(w.lead), " at (", Math(self.phrases.math(place.x).expr), ", ", Math(self.phrases.math(place.y).expr), ")"]  # type: ignore[attr-defined]
        if through:
            parts += [", where ", Math(through[0]), " and ", Math(through[1]), " meet, so that neither enters:"]
        else:
            parts += [", about which the group turns in a virtual motion:"]
        return line(*parts)

    # --- step 3 ------------------------------------------------------------------------------------------------------

    def _count(self, stage: Stage) -> Line:
        equations = sum(len(b.equations) for b in stage.blocks)
        unknowns = [u for b in stage.blocks for u in b.unknowns]
        noun = "equation" if equations == 1 else "equations"
        parts: list[Any] = [f"{equations} {noun}, {len(unknowns)} unknown{'s' if len(unknowns) != 1 else ''}: "]
        for i, u in enumerate(unknowns):
            parts += [", " if i else "", Math(u)]
        return line(*parts)

    def _solving(self, stage: Stage) -> list[Block]:
        blocks: list[Block] = []
        for block in stage.blocks:
            blocks += self._block(block)
        return blocks

    def _block(self, block: SolvedBlock) -> list[Block]:
        blocks: list[Block] = []
        if len(block.unknowns) > 1:
            parts: list[Any] = ["Together: ", ", ".join(f"({w.number})" for w in block.equations)]
            if block.letters:
                parts.append(", in terms of ")
                for i, s in enumerate(block.letters):
                    parts += [", " if i else "", Math(s)]
            blocks.append(Paragraph(line(*parts)))
        return [*blocks, *(self._line(x) for x in block.lines)]

    def _line(self, x: SolvedLine) -> Block:
        lead = line(" and ".join(f"({n})" for n in x.equations) + ":")
        if x.letters:
            return Equation((self.phrases.math(x.symbol), self.phrases.math(x.formula)), None, lead)
        return Equation(self._chain(x.symbol, x.formula, self.phrases.shown(x.symbol, x.value)), None, lead)


def check_blocks(instant: InstantSolution, figures: int) -> list[Block]:
    """What was checked."""
    return [Check(line(text)) for text in instant.checks.get("lines", ())]
