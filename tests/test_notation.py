"""Expressions and names in both notations."""

from __future__ import annotations

from typing import Any

import pytest
import sympy
from sympy import Abs, Add, Eq, Mul, Rational, Symbol, atan, cos, exp, pi, sin, sqrt

from planar_cli.report.notation.names import latex_name, plain_name
from planar_cli.report.notation.notation import latex, plain

_NAMES = "P F R r L h x m M m_1 m_2 g t v v_0 k k_G mu_k N I_G a_G alpha omega_AB theta"
S = {name: Symbol(name, positive=True) for name in _NAMES.split()}
P, F, R, r, L, h, x, m, M, m_1, m_2, g, t, v, v_0, k, gyration, mu_k, N, inertia, acceleration, alpha, omega, theta = (
    S.values()
)


@pytest.mark.parametrize(
    ("name", "text", "tex"),
    [
        ("m", "m", "m"),
        ("limit.a_max", "a_max", r"a_{\mathrm{max}}"),
        ("alpha", "α", r"\alpha"),
        ("omega_AB", "ω_AB", r"\omega_{AB}"),
        ("mu_k", "μ_k", r"\mu_{k}"),
        ("k_G", "k_G", "k_{G}"),
        ("a_Gx", "a_Gx", "a_{Gx}"),
        ("a_G_x", "a_Gx", "a_{Gx}"),
        ("a_G_theta", "a_Gθ", r"a_{G\theta}"),
        ("v_D_AB", "v_D/AB", "v_{D/AB}"),
        ("v_D_AB_x", "v_D/AB,x", "v_{D/AB,x}"),
        ("J_N_C", "J_N,C", "J_{N,C}"),
        ("J_O_Ax__2", "J_O,Ax,2", "J_{O,Ax,2}"),
        ("v_A_B_C", "v_A,B,C", "v_{A,B,C}"),
        ("r_A2_from_A", "r_A2_from_A", r"\mathrm{r\_A2\_from\_A}"),
        ("r_B_at_2s", "r_B_at_2s", r"\mathrm{r\_B\_at\_2s}"),
        ("v_B_1", "v_B1", "v_{B1}"),
        ("v_B1", "v_B1", "v_{B1}"),
        ("F_s_max", "F_s,max", r"F_{s,\mathrm{max}}"),
        ("theta1", "θ1", r"\theta_{1}"),
        ("m1", "m1", "m_{1}"),
        ("speed", "speed", r"\mathrm{speed}"),
        ("v_A_prime", "v_A′", "v_{A}'"),
        ("theta_dot", "θ\u0307", r"\dot{\theta}"),
        ("Delta_t", "Δt", r"\Delta t"),
        ("ΣM_C", "ΣM_C", r"\Sigma M_{C}"),
        ("_", "", ""),
    ],
)
def test_names(name: str, text: str, tex: str) -> None:
    assert plain_name(name) == text
    assert latex_name(name) == tex


def unevaluated_sum(*terms: Any) -> Any:
    return Add(*terms, evaluate=False)


def unevaluated_product(*factors: Any) -> Any:
    return Mul(*factors, evaluate=False)


@pytest.mark.parametrize(
    ("expr", "text", "tex"),
    [
        (
            -P * (R + r) / (m * (R**2 + gyration**2)),
            "-P (R + r) / (m (R² + k_G²))",
            r"-\frac{P (R + r)}{m (R^{2} + k_{G}^{2})}",
        ),
        (m * alpha * (R**2 + gyration**2), "m (R² + k_G²) α", r"m (R^{2} + k_{G}^{2}) \alpha"),
        ((m_1 - m_2) * g / (m_1 + m_2), "(m_1 - m_2) g / (m_1 + m_2)", r"\frac{(m_{1} - m_{2}) g}{m_{1} + m_{2}}"),
        (m_2 - m_1, "m_2 - m_1", "m_{2} - m_{1}"),
        (m * v**2 / 2, "1/2 m v²", r"\frac{1}{2} m v^{2}"),
        (7 * v**2 / (10 * m), "7 v²/(10 m)", r"\frac{7 v^{2}}{10 m}"),
        (m * Symbol("e") * R * alpha, "m e R α", r"m e R \alpha"),
        (m * Symbol("e") * v, "e m v", r"e m v"),
        (Rational(2, 5) * m * r**2, "2/5 m r²", r"\frac{2}{5} m r^{2}"),
        (Rational(9, 20) * P, "0.45 P", "0.45 P"),
        (5 * g / 6, "5 g/6", r"\frac{5 g}{6}"),
        (-3 * g / 4, "-3 g/4", r"-\frac{3 g}{4}"),
        (3 * g * sin(theta) / (2 * L), "3 g sin θ / (2 L)", r"\frac{3 g \sin \theta}{2 L}"),
        (v**2 / R, "v²/R", r"\frac{v^{2}}{R}"),
        (1 / (R * r), "1/(R r)", r"\frac{1}{R r}"),
        (R**-2, "1/R²", r"\frac{1}{R^{2}}"),
        (sqrt(R * r), "√(R r)", r"\sqrt{R r}"),
        (sqrt(2), "√2", r"\sqrt{2}"),
        (sqrt(g), "√g", r"\sqrt{g}"),
        (sqrt(2 * g * h), "√(2 g h)", r"\sqrt{2 g h}"),
        (sqrt(g / L), "√(g/L)", r"\sqrt{\frac{g}{L}}"),
        (sqrt(6 * g * L) / 3, "√(2 g L/3)", r"\sqrt{\frac{2 g L}{3}}"),
        (sqrt(R**2 + r**2), "√(R² + r²)", r"\sqrt{R^{2} + r^{2}}"),
        (1 / sqrt(L), "1/√L", r"\frac{1}{\sqrt{L}}"),
        (sqrt(2) * L * alpha / 2, "√2/2 L α", r"\frac{\sqrt{2}}{2} L \alpha"),
        (R ** Rational(3, 2), "R^(3/2)", r"R^{\frac{3}{2}}"),
        ((R + r) ** 2, "(R + r)²", "(R + r)^{2}"),
        (x**10, "x¹⁰", "x^{10}"),
        (x**k, "x^k", "x^{k}"),
        (x + v_0 * t - g * t**2 / 2, "x + v_0 t - 1/2 g t²", r"x + v_{0} t - \frac{1}{2} g t^{2}"),
        (
            m * g * (sin(theta) - mu_k * cos(theta)),
            "m g (sin θ - μ_k cos θ)",
            r"m g (\sin \theta - \mu_{k} \cos \theta)",
        ),
        (v_0 * t * cos(theta), "v_0 t cos θ", r"v_{0} t \cos \theta"),
        (R * omega**2, "R ω_AB²", r"R \omega_{AB}^{2}"),
        (mu_k * N, "μ_k N", r"\mu_{k} N"),
        (P * cos(pi / 180 * 35), "P cos 35°", r"P \cos 35^{\circ}"),
        (cos(theta + pi / 6), "cos(θ + 30°)", r"\cos(\theta + 30^{\circ})"),
        (sin(2 * theta), "sin(2 θ)", r"\sin(2 \theta)"),
        (sin(theta) ** 2, "sin² θ", r"\sin^{2} \theta"),
        (atan(F / N), "arctan(F/N)", r"\arctan\left(\frac{F}{N}\right)"),
        (exp(-k * t), "exp(-k t)", r"\exp(-k t)"),
        (1 - cos(theta), "1 - cos θ", r"1 - \cos \theta"),
        (m * R * Abs(Symbol("w")) - P, "m R |w| - P", r"m R \lvert w \rvert - P"),
        (-R - r, "-R - r", "-R - r"),
        (pi * R / 2, "π R/2", r"\frac{\pi R}{2}"),
        (Rational(1, 2), "1/2", r"\frac{1}{2}"),
        (Rational(981, 100), "9.81", "9.81"),
        (sympy.Integer(12345678901), "1.23457×10¹⁰", r"1.23457 \times 10^{10}"),
        (sympy.Float("-0.25"), "-0.25", "-0.25"),
        (sympy.Integer(0), "0", "0"),
        (Eq(F, m * acceleration), "F = m a_G", "F = m a_{G}"),
        (x <= L, "x ≤ L", r"x \le L"),
    ],
)
def test_expressions(expr: Any, text: str, tex: str) -> None:
    assert plain(expr) == text
    assert latex(expr) == tex


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (unevaluated_sum(P, F), "P + F"),
        (unevaluated_sum(unevaluated_product(-1, m, acceleration, R), inertia * alpha), "-m a_G R + I_G α"),
        (unevaluated_product(-1, R + r), "-(R + r)"),
        (unevaluated_product(cos(theta), R), "cos(θ) R"),
        (unevaluated_sum(x, unevaluated_product(-1, R - r)), "x - (R - r)"),
        (unevaluated_product(m, R, alpha, R), "m R α R"),
    ],
)
def test_the_order_of_an_author_is_kept(expr: Any, text: str) -> None:
    assert plain(expr) == text


@pytest.mark.parametrize(
    ("expr", "values", "text"),
    [
        (
            -P * (R + r) / (m * (R**2 + gyration**2)),
            {P: "100", R: "0.45", r: "0.3", m: "50", gyration: "0.2"},
            "-100 (0.45 + 0.3) / (50 (0.45² + 0.2²))",
        ),
        (-P * (R + r) / m, {P: "-100", R: "0.45", r: "-0.3", m: "-50"}, "-(-100) (0.45 - 0.3) / (-50)"),
        (m * g * R, {m: "50", g: "9.81", R: "0.45"}, "50 · 9.81 · 0.45"),
        (m * v**2 / 2, {m: "50", v: "-3.2"}, "1/2 · 50 · 3.2²"),
        (m * v**2 / R, {m: "50", v: "3.2", R: "0.45"}, "50 · 3.2² / 0.45"),
        (R - r, {R: "-1", r: "-2"}, "-1 - (-2)"),
        (P * cos(theta), {P: "20", theta: "35°"}, "20 cos 35°"),
        (cos(theta), {theta: "0.3"}, "cos(0.3)"),
        (sqrt(2 * g * h), {g: "9.81", h: "0.5"}, "√(2 · 9.81 · 0.5)"),
        (m * g, {m: "1/2"}, "(1/2) g"),
        (m**2, {m: "2×10⁶"}, "(2×10⁶)²"),
        (m * acceleration, {m: "50"}, "50 a_G"),
    ],
)
def test_substituted_numbers(expr: Any, values: dict[Any, str], text: str) -> None:
    assert plain(expr, values) == text


def test_powers_of_ten_in_latex() -> None:
    assert latex(m**2, {m: "2×10⁻⁶"}) == r"(2 \times 10^{-6})^{2}"


@pytest.mark.parametrize("name", ["\\input{/etc/passwd}", "$x$", "\x1b[31m", "\u202ex", "a%b", "<b>", "#{}~^&"])
def test_hostile_names_are_harmless(name: str) -> None:
    tex = latex(Symbol(name))
    for command in ("\\input", "<", "\x1b", "\u202e"):
        assert command not in tex
    assert all(tex[i - 1 : i] == "\\" for i, c in enumerate(tex) if c in "$%#&")
    assert plain(Symbol(name)).isprintable()
