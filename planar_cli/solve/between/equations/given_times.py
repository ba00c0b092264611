"""The times at which the file puts states."""

from __future__ import annotations

import sympy as sp

from planar_cli.solve.between.equations.stated_motion import StatedMotion


def without_end(course: StatedMotion, k: int) -> bool:
    """Is state k at t = infinity?"""
    return any(d.kind == "limit" for d in course.demands[course.states[k].name])


def endless_times(course: StatedMotion) -> list[sp.Symbol]:
    """The times of states that are only approached."""
    return [course.stops[s.name].t for k, s in enumerate(course.states) if without_end(course, k)]


def asked_without_end(course: StatedMotion, k: int) -> list[int]:
    """State k and what its relations speak of, as far as that is at t = infinity and not before it in the file."""
    spoken = {s for d in course.demands[course.states[k].name] for s in d.residual.free_symbols}
    later = [n for n in range(k, len(course.states)) if without_end(course, n)]
    return [n for n in later if n == k or spoken & set(course.stops[course.states[n].name].letters.values())]
