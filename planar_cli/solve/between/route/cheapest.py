"""The cheapest derivation of every unknown, found in order of cost (after Knuth's generalisation of Dijkstra's
algorithm). The cost of an unknown is that of its equations and of all that they rest on, each counted once: a balance
of energies of many bodies needs many places, but these all follow from one angle.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Sequence

import sympy as sp

from planar_cli.solve.between.trace.derivation import Derivation, Edge


def cheapest(edges: Sequence[Edge]) -> dict[sp.Symbol, Derivation]:
    """By unknown; those that nothing reaches are left out."""
    waiting = {i: len(needs) for i, (_, _, needs, _) in enumerate(edges)}
    users: dict[sp.Symbol, list[int]] = {}
    for i, (_, _, needs, _) in enumerate(edges):
        for s in needs:
            users.setdefault(s, []).append(i)
    rests: dict[sp.Symbol, frozenset[int]] = {}
    best: dict[sp.Symbol, Derivation] = {}
    queue: list[tuple[float, int]] = [(edges[i][3], i) for i, n in waiting.items() if n == 0]
    heapq.heapify(queue)
    while queue:
        cost, i = heapq.heappop(queue)
        equations, unknowns, needs, _ = edges[i]
        fresh = [x for x in unknowns if x not in best]
        if not fresh:
            continue
        derivation, way = Derivation(equations, unknowns, needs, cost), _way(i, needs, rests)
        for x in fresh:
            best[x], rests[x] = derivation, way
            for j in users.get(x, ()):
                waiting[j] -= 1
                if waiting[j] == 0:
                    cost = math.fsum(edges[k][3] for k in _way(j, edges[j][2], rests))
                    heapq.heappush(queue, (cost, j))
    return best


def _way(edge: int, needs: frozenset[sp.Symbol], rests: dict[sp.Symbol, frozenset[int]]) -> frozenset[int]:
    """An edge with all on which its needs rest, by their numbers."""
    return frozenset((edge,)).union(*(rests[s] for s in needs))
