"""What is said of units that are no unit of the list: nothing that would change the size of the quantity."""

from __future__ import annotations

import pytest

from planar_cli.problem.structure import load_text
from planar_cli.units import UnitError, parse_unit


def hint(unit: str) -> str:
    text = f"title: One unit\ngiven: {{q: 2 {unit}}}\npoints: {{A: [0, 0]}}\nfind: {{q: q}}\n"
    return next(d.hint for d in load_text(text)[1] if d.code == "PL203")


@pytest.mark.parametrize(
    ("unit", "said"),
    [
        ("Mg", "`tonne`: 1 Mg is 1000 kg"),
        ("MG", "with a capital M a million"),
        ("mpa", "with a capital M a million"),
        ("mJ", "1 mJ is 0.001 J"),
        ("mW", "1 mW is 0.001 W"),
        ("um", "1 um is 10^-6 m"),
        ("dm", "1 dm is 0.1 m"),
        ("hPa", "1 hPa is 100 Pa"),
        ("ton", "2000 lb"),
        ("kips", "`kip`"),
        ("slugs", "`slug`"),
        ("HP", "`hp`"),
        ("KN", "`kN`"),
        ("lb-ft", "`lbf*ft`"),
        ("ft-lb", "`ft*lbf`"),
        ("in-lb", "`in*lbf`"),
        ("lb-s", "`lbf*s`"),
        ("kN-m", "`kN*m`"),
        ("kg-m^2", "`kg*m^2`"),
        ("slug-ft^2", "`slug*ft^2`"),
        ("lb-ft^2", "`lb*ft^2`"),
        ("in.", "`in`"),
        ("deg.", "`deg`"),
        ("knots", "1.852 km/h"),
        ("kWh", "3.6 MJ"),
        ("bar", "100 kPa"),
        ("oz", "1/16 lb"),
        ("Nms", "`N*m*s`"),
    ],
)
def test_the_hint_keeps_the_size(unit: str, said: str) -> None:
    assert said in hint(unit)


@pytest.mark.parametrize("unit", ["um", "Mg", "dm", "mJ", "Gg", "pcs", "Ws", "gm", "mPa"])
def test_no_other_unit_is_offered_because_its_letters_are_alike(unit: str) -> None:
    with pytest.raises(UnitError) as caught:
        parse_unit(unit)
    assert "did you mean" not in caught.value.hint
