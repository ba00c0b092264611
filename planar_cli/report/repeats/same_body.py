"""A second moment of inertia of a body right below its own names the axis alone:

moment of inertia of CB:   I_CB = 1/12 m c² = 0.02667 kg·m²
about C, parallel axes:    I_C = 1/4 m c² + I_CB = 0.1067 kg·m²
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Equation, line

OF, ABOUT, PARALLEL = "moment of inertia of ", " about ", ", parallel axes:"


def with_axes_alone(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a page."""
    found: list[Block] = []
    body = ""
    for block in blocks:
        lead = as_text(block.lead) if isinstance(block, Equation) and block.number is None else ""
        again = body and lead.startswith(OF + body + ABOUT) and lead.endswith(PARALLEL)
        alone = line(lead.removeprefix(OF + body).lstrip())
        found.append(replace(block, lead=alone) if again and isinstance(block, Equation) else block)
        body = lead.removeprefix(OF).removesuffix(":") if lead.startswith(OF) and ABOUT not in lead else ""
    return found
