"""From which point of another body the file places a body with its coordinates: it goes along with that."""

from __future__ import annotations

from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.scene import GROUND, At, Polar


def placed_from(scene: Scene, body: str) -> tuple[str, str]:
    """The other body and its point, `{from: O, ...}`, or the point O of a cart at which a rod [O, P] begins; the
    ground if there is none.
    """
    shape = scene.bodies[body].shape
    names = [n for k in ("place", "start", "center") if isinstance(n := getattr(shape, k, None), str)]
    places = {p.name: p.place for p in scene.problem.points}
    origins = [p.origin for n in names if isinstance(p := places.get(n), Polar)]
    origins += [n for n in names if isinstance(places.get(n), At) and not _is_written(scene, n)]
    return (scene.owner(origins[0], body), origins[0]) if origins else (GROUND, "")


def _is_written(scene: Scene, point: str) -> bool:
    """Does the file write this point with a coordinate?"""
    place = scene.point(point)
    return bool((place.x.free_symbols | place.y.free_symbols) & set(scene.ledger.coordinates))
