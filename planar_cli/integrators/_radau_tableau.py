"""The coefficients of Radau IIA with five stages, computed with 60 digits from what defines them.

The nodes are the zeros of the fourth derivative of x⁴ (x - 1)⁵, the method is collocation there. A is the matrix of its
weights; A⁻¹ = V Λ V⁻¹ splits the stages' equations into a real one and two complex ones (those conjugate to the latter
are left out). E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8.
"""

from __future__ import annotations

NODES: tuple[float, ...] = (
    0.05710419611451768,
    0.2768430136381238,
    0.5835904323689168,
    0.8602401356562195,
    1.0,
)
"""The stages' times, in steps."""
REAL: float = 6.2867047517292765
"""The real eigenvalue of A⁻¹."""
COMPLEX: tuple[complex, ...] = (
    complex(5.70095329867179, 3.2102656003085497),
    complex(3.655694325463572, 6.543736899360077),
)
"""One of each pair of complex eigenvalues."""
REAL_VECTOR: tuple[float, ...] = (
    0.013576867344947943,
    0.0016179004017190875,
    0.07915785334744721,
    0.41225608268046143,
    1.0,
)
"""The column of V that belongs to the real eigenvalue."""
COMPLEX_VECTORS: tuple[tuple[complex, ...], ...] = (
    (
        complex(-0.02295703051045903, 0.02803971778575082),
        complex(-0.015337661498360326, -0.049417156853037054),
        complex(0.0387969279976579, -0.16360070740750235),
        complex(0.8152023425603981, -0.39936485577360503),
        complex(2.0, 0.0),
    ),
    (
        complex(-0.020484095635817653, -0.09534775458059144),
        complex(0.10034572903474212, 0.18866363836322286),
        complex(-0.4610790680868359, -0.2054060907602518),
        complex(0.7557878044977225, -0.9334882606649887),
        complex(2.0, 0.0),
    ),
)
"""Twice the columns of V that belong to the complex ones: of the sum with the conjugate the real part counts."""
REAL_ROW: tuple[float, ...] = (
    27.697693775684087,
    12.783337911304406,
    3.20848938671343,
    -0.9514904122489162,
    0.7415504960259897,
)
"""The row of V⁻¹ that belongs to the real eigenvalue."""
COMPLEX_ROWS: tuple[tuple[complex, ...], ...] = (
    (
        complex(-16.5209401067595, -4.305721989937646),
        complex(-8.688476739531783, 4.849995704764404),
        complex(-0.08606453162700278, 0.9573643198484372),
        complex(-0.04958488899127132, 1.20934600304247),
        complex(0.2656140579191533, -0.5237317439676688),
    ),
    (
        complex(2.672093218917456, 1.8740299037199024),
        complex(2.2968077838795806, -1.9924828681719424),
        complex(-1.5181801617297122, -0.5222078208040094),
        complex(0.5253300951157295, 0.5920492840689743),
        complex(-0.13638930593214812, -0.22495888507839018),
    ),
)
"""The rows of V⁻¹ that belong to the complex ones."""
ERROR: tuple[float, ...] = (
    -4.418997716796381,
    0.57923485225667,
    -0.199237560953468,
    0.09416748369194548,
    -0.03181316888549383,
)
"""Weights of the stages in the error of order 5, beside h/REAL times the rates at the start."""
