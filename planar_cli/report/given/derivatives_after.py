"""The order of what a file gives together with its derivative: v = t², then a = 2 t."""

from __future__ import annotations

from planar_cli.solve.instant.written import Written


def derivatives_after(relations: list[Written]) -> list[Written]:
    """The same, what the file gives before its derivatives, in the places that they had together."""
    found = list(relations)
    for words in dict.fromkeys(w.words or w.lead for w in relations if w.source == "given" and w.times):
        places = [i for i, w in enumerate(relations) if w.source == "given" and (w.words or w.lead) == words]
        own = sorted((relations[i] for i in places), key=lambda w: w.times)
        for i, w in zip(places, own, strict=True):
            found[i] = w
    return found
