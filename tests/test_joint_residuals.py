"""Every joint in every mode: its facts and its position residuals must forbid the same motions, and bend them alike.

Scenes are drawn at random. Velocities that the residuals allow must satisfy the facts; then the rows of both, with their
constant parts (centripetal, Coriolis, the turning of ropes), must span the same space.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Iterator
from decimal import Decimal
from string import Template

import pytest

from planar_cli.equation.exact import ZERO, Valuation
from planar_cli.joints.base import Joint
from planar_cli.problem.facts import Mode
from planar_cli.problem.geometry import Vec
from planar_cli.problem.structure import load_text
from planar_cli.registry import members
from planar_cli.solve.assembly import Assembly
from planar_cli.solve.instant import Instant, make_instant
from planar_cli.solve.linear import solve
from planar_cli.solve.multibody import tidied
from planar_cli.solve.poses import NearPoses, Place
from planar_cli.solve.sparse import CONSTANT, Echelon, Line
from planar_cli.solve.time_jets import TimeJet

CAR = "car: {points: [K, L], center: K}"
POINTS = "K: [$x m, $y m], L: [$z m, 1 m]"

SCENES = {
    # --- pins, welds, links, belts ---------------------------------------------------------------------------------
    "pin of two": ("A: [$x m, $y m], B: [$z m, 1 m], C: [2 m, $x m]", "AB: {rod: [A, B]}, BC: {rod: [B, C]}", "",
                   "pin: {at: B, between: [AB, BC]}"),
    "pin to ground": ("A: [$x m, $y m], B: [$z m, 1 m]", "AB: {rod: [A, B]}", "", "pin: {at: B, between: [ground, AB]}"),
    "pin of three": ("A: [$x m, $y m], B: [$z m, 1 m], C: [2 m, $x m], D: [$y m, 3 m]",
                     "AB: {rod: [A, B]}, BC: {rod: [B, C]}, BD: {rod: [B, D]}", "", "pin: {at: B, between: [AB, BC, BD]}"),
    "pin of a particle": ("A: [$x m, $y m], B: [$z m, 1 m]", "AB: {rod: [A, B]}, P: {particle: B}", "",
                          "pin: {at: B, between: [AB, P]}"),
    "rough pin": ("A: [$x m, $y m], B: [$z m, 1 m], C: [2 m, $x m]", "AB: {rod: [A, B]}, BC: {rod: [B, C]}", "",
                  "pin: {at: B, between: [AB, BC], friction_torque: 2 N*m}"),
    "rough pin to ground": ("A: [$x m, $y m], B: [$z m, 1 m]", "AB: {rod: [A, B]}", "",
                            "pin: {at: B, between: [AB, ground], friction_torque: 2 N*m}"),
    "weld": ("A: [$x m, $y m], B: [$z m, 1 m], C: [2 m, $x m]", "AB: {rod: [A, B]}, BC: {rod: [B, C]}", "",
             "weld: {at: B, between: [AB, BC]}"),
    "weld of a particle": ("A: [$x m, $y m], B: [$z m, 1 m]", "AB: {rod: [A, B]}, P: {particle: B}", "",
                           "weld: {at: B, between: [AB, P]}"),
    "link": ("A: [$x m, $y m], B: [$z m, 1 m], C: [2 m, $x m], D: [$y m, 3 m]", "AB: {rod: [A, B]}, CD: {rod: [C, D]}", "",
             "link: {between: [A, D]}"),
    "link to ground": ("A: [$x m, $y m], B: [$z m, 1 m], O: [0, 4 m]", "AB: {rod: [A, B]}", "", "link: {between: [O, B]}"),
    "link of particles": ("A: [$x m, $y m], B: [$z m, 1 m]", "P: {particle: A}, Q: {particle: B}", "", "link: {between: [A, B]}"),
    "open belt": ("A: [$x m, 0], B: [3 m, $y m]", "a: {disk: A, radius: $r m}, b: {disk: B, radius: 0.3 m}", "",
                  "belt: {between: [a, b]}", "link: {between: [A, B]}"),
    "crossed belt": ("A: [$x m, 0], B: [3 m, $y m]", "a: {disk: A, radius: $r m}, b: {disk: B, radius: 0.3 m}", "",
                     "belt: {between: [a, b], crossed: true}", "link: {between: [A, B]}"),
    # --- guides ----------------------------------------------------------------------------------------------------
    "fixed guide": ("A: [$x m, $y m], B: [$z m, 1 m]", "AB: {rod: [A, B]}", "", "guide: {point: B, along: $a deg}"),
    "slot in a rod": ("A: [0, 0], B: [2 m, $y m], C: [1 m, 3 m], D: {from: A, towards: B, distance: $r m}",
                      "AB: {rod: [A, B]}, CD: {rod: [C, D]}", "", "guide: {point: D, along: AB}"),
    "collar on a rod": ("A: [0, 0], B: [2 m, $y m], D: {from: A, towards: B, distance: $r m}",
                        "AB: {rod: [A, B]}, c: {plate: D, width: 0.2 m, height: 0.1 m}", "", "guide: {body: c, along: AB}"),
    "particle in a slot": ("A: [0, 0], B: [2 m, $y m], D: {from: A, towards: B, distance: $r m}",
                           "AB: {rod: [A, B]}, P: {particle: D}", "", "guide: {point: D, along: AB}"),
    "piston": ("A: [$x m, $y m]", "p: {plate: A, width: 0.2 m, height: 0.1 m}", "", "guide: {body: p, along: $a deg, mu: 0.2}"),
    "rough slot": ("A: [0, 0], B: [2 m, $y m], C: [1 m, 3 m], D: {from: A, towards: B, distance: $r m}",
                   "AB: {rod: [A, B]}, CD: {rod: [C, D]}", "", "guide: {point: D, along: AB, mu: 0.2}"),
    "circular track": ("O: [$x m, $y m], B: {from: O, distance: $r m, angle: $a deg}, C: [4 m, $z m]", "BC: {rod: [B, C]}",
                       "ring: {center: O, radius: $r m}", "guide: {point: B, along: ring}"),
    "moving circular track": (f"{POINTS}, O: [$x m, $y m], B: {{from: O, distance: $r m, angle: $a deg}}, C: [4 m, $z m]",
                              f"{CAR}, BC: {{rod: [B, C]}}", "ring: {center: O, radius: $r m, body: car}",
                              "guide: {point: B, along: ring}"),
    "curved track": ("B: [$x m, (0.3/(1 m)) * ($x m)^2], C: [4 m, $z m]", "BC: {rod: [B, C]}", "hill: {y: (0.3/(1 m))*x^2}",
                     "guide: {point: B, along: hill}"),
    "spiral track": ("B: {from: O, distance: (0.2 m)*($a deg), angle: $a deg}, C: [4 m, $z m], O: [0, 0]", "BC: {rod: [B, C]}",
                     "cam: {r: (0.2 m)*theta}", "guide: {point: B, along: cam}"),
    "collar on a carried ring": (f"{POINTS}, O: [$x m, $y m], B: {{from: O, distance: $r m, angle: $a deg}}",
                                 f"{CAR}, c: {{plate: B, width: 0.2 m, height: 0.1 m}}",
                                 "ring: {center: O, radius: $r m, body: car}", "guide: {body: c, along: ring, mu: 0.2}"),
    "collar on a ring": ("O: [$x m, $y m], B: {from: O, distance: $r m, angle: $a deg}",
                         "c: {plate: B, width: 0.2 m, height: 0.1 m}", "ring: {center: O, radius: $r m}",
                         "guide: {body: c, along: ring}"),
    # --- rolling -----------------------------------------------------------------------------------------------------
    "wheel on a floor": ("C: [0, 0], G: {from: C, distance: $r m, angle: $b deg}", "w: {disk: G, radius: $r m}",
                         "floor: {through: C, angle: $b deg + 90 deg}", "rolling: {between: [w, floor], at: C}"),
    "wheel on a moving deck": (f"{POINTS}, C: [0, 0], G: {{from: C, distance: $r m, angle: $b deg}}",
                               f"{CAR}, w: {{disk: G, radius: $r m}}", "deck: {through: C, angle: $b deg - 90 deg, body: car}",
                               "rolling: {between: [w, deck], at: C}"),
    "wheel on a belt": ("C: [0, 0], G: {from: C, distance: $r m, angle: $b deg}", "w: {disk: G, radius: $r m}",
                        "floor: {through: C, angle: $b deg + 90 deg, speed: 3 m/s}", "rolling: {between: [w, floor], at: C}"),
    "wheel on a carried belt": (f"{POINTS}, C: [0, 0], G: {{from: C, distance: $r m, angle: $b deg}}",
                                f"{CAR}, w: {{disk: G, radius: $r m}}",
                                "deck: {through: C, angle: $b deg - 90 deg, body: car, speed: 3 m/s}",
                                "rolling: {between: [w, deck], at: C}"),
    "gears": ("A: [$x m, $y m], C: {from: A, distance: $r m, angle: $a deg}, B: {from: A, distance: $r m + 0.7 m, angle: $a deg}",
              "a: {disk: A, radius: $r m}, b: {disk: B, radius: 0.7 m}", "", "rolling: {between: [a, b], at: C}"),
    "wheel in a drum": ("O: [$x m, $y m], C: {from: O, distance: 2 m, angle: $a deg}, B: {from: O, distance: 2 m - $r m, angle: $a deg}",
                        "d: {disk: O, radius: 2 m}, b: {disk: B, radius: $r m}", "", "rolling: {between: [d, b], at: C}"),
    "wheel in a trough": ("O: [$x m, $y m], C: {from: O, distance: 2 m, angle: $a deg}, B: {from: O, distance: 2 m - $r m, angle: $a deg}",
                          "b: {disk: B, radius: $r m}", "bowl: {center: O, radius: 2 m}", "rolling: {between: [bowl, b], at: C}"),
    "wheel over a hump": ("O: [$x m, $y m], C: {from: O, distance: 2 m, angle: $a deg}, B: {from: O, distance: 2 m + $r m, angle: $a deg}",
                          "b: {disk: B, radius: $r m}", "hump: {center: O, radius: 2 m}", "rolling: {between: [b, hump], at: C}"),
    "wheel on a carried hump": (f"{POINTS}, O: [$x m, $y m], C: {{from: O, distance: 2 m, angle: $a deg}}, "
                                "B: {from: O, distance: 2 m + $r m, angle: $a deg}", f"{CAR}, b: {{disk: B, radius: $r m}}",
                                "hump: {center: O, radius: 2 m, body: car}", "rolling: {between: [b, hump], at: C}"),
    "wheel on a curve": ("C: [0, 0], G: [0, $r m]", "w: {disk: G, radius: $r m}", "road: {y: (0.2/(1 m))*x^2 }",
                         "rolling: {between: [w, road], at: C}"),
    "wheel under a curve": ("C: [0, 0], G: [0, -$r m]", "w: {disk: G, radius: $r m}", "road: {y: (0.2/(1 m))*x^2 }",
                            "rolling: {between: [w, road], at: C}"),
    "plank on a log": ("O: [$x m, $y m], C: {from: O, distance: $r m, angle: $a deg}, A: {from: C, distance: 1 m, angle: $a deg + 90 deg}, "
                       "B: {from: C, distance: 2 m, angle: $a deg - 90 deg}", "AB: {rod: [A, B]}", "trunk: {center: O, radius: $r m}",
                       "rolling: {between: [AB, trunk], at: C}"),
    "plank on a rolling log": ("O: [$x m, $y m], C: {from: O, distance: $r m, angle: $a deg}, A: {from: C, distance: 1 m, angle: $a deg + 90 deg}, "
                               "B: {from: C, distance: 2 m, angle: $a deg - 90 deg}", "AB: {rod: [A, B]}, trunk: {disk: O, radius: $r m}", "",
                               "rolling: {between: [AB, trunk], at: C}"),
    # --- contact -----------------------------------------------------------------------------------------------------
    "ladder on a floor": ("A: [0, 0], B: [$x m, $y m]", "AB: {rod: [A, B]}", "floor: {through: A, angle: 0 deg}",
                          "contact: {between: [AB, floor], at: A, mu: 0.3}"),
    "rod on a moving deck": (f"{POINTS}, A: [0, 0], B: [$x m, $y m]", f"{CAR}, AB: {{rod: [A, B]}}",
                             "deck: {through: A, angle: $a deg, body: car}", "contact: {between: [AB, deck], at: A, mu: 0.3}"),
    "rod on a carried belt": (f"{POINTS}, A: [0, 0], B: [$x m, $y m]", f"{CAR}, AB: {{rod: [A, B]}}",
                              "deck: {through: A, angle: $a deg, body: car, speed: 2 m/s}",
                              "contact: {between: [AB, deck], at: A, mu: 0.3}"),
    "rod in a bowl": ("O: [$x m, $y m], B: {from: O, distance: $r m, angle: $a deg}, C: [4 m, $z m]", "BC: {rod: [B, C]}",
                      "bowl: {center: O, radius: $r m}", "contact: {between: [BC, bowl], at: B, mu: 0.3}"),
    "rod in a moving bowl": (f"{POINTS}, O: [$x m, $y m], B: {{from: O, distance: $r m, angle: $a deg}}, C: [4 m, $z m]",
                             f"{CAR}, BC: {{rod: [B, C]}}", "bowl: {center: O, radius: $r m, body: car}",
                             "contact: {between: [BC, bowl], at: B, mu: 0.3}"),
    "particle on a hill": ("B: [$x m, -(0.3/(1 m)) * ($x m)^2]", "P: {particle: B}", "hill: {y: (-0.3/(1 m))*x^2}",
                           "contact: {between: [P, hill], at: B, mu: 0.3}"),
    "particle on a disk": ("O: [$x m, $y m], B: {from: O, distance: $r m, angle: $a deg}", "P: {particle: B}, d: {disk: O, radius: $r m}",
                           "", "contact: {between: [P, d], at: B, mu: 0.3}"),
    "wheel that may slip": (f"{POINTS}, C: [0, 0], G: {{from: C, distance: $r m, angle: $b deg}}", f"{CAR}, w: {{disk: G, radius: $r m}}",
                            "deck: {through: C, angle: $b deg - 90 deg, body: car}", "contact: {between: [w, deck], at: C, mu: 0.3}"),
    "wheel dropped on a belt": ("C: [0, 0], G: {from: C, distance: $r m, angle: $b deg}", "w: {disk: G, radius: $r m}",
                                "floor: {through: C, angle: $b deg + 90 deg, speed: 3 m/s}",
                                "contact: {between: [w, floor], at: C, mu: 0.3}"),
    "two wheels": ("A: [$x m, $y m], C: {from: A, distance: $r m, angle: $a deg}, B: {from: A, distance: $r m + 0.7 m, angle: $a deg}",
                   "a: {disk: A, radius: $r m}, b: {disk: B, radius: 0.7 m}", "", "contact: {between: [a, b], at: C, mu: 0.3}"),
    "wheel in a bowl": ("O: [$x m, $y m], C: {from: O, distance: 2 m, angle: $a deg}, B: {from: O, distance: 2 m - $r m, angle: $a deg}",
                        "b: {disk: B, radius: $r m}", "bowl: {center: O, radius: 2 m}", "contact: {between: [bowl, b], at: C, mu: 0.3}"),
    "wheel in a moving bowl": (f"{POINTS}, O: [$x m, $y m], C: {{from: O, distance: 2 m, angle: $a deg}}, "
                               "B: {from: O, distance: 2 m - $r m, angle: $a deg}", f"{CAR}, b: {{disk: B, radius: $r m}}",
                               "bowl: {center: O, radius: 2 m, body: car}", "contact: {between: [b, bowl], at: C, mu: 0.3}"),
    "wheel on a road that bends": ("C: [0, 0], G: [0, $r m]", "w: {disk: G, radius: $r m}", "road: {y: (0.2/(1 m))*x^2 }",
                                   "contact: {between: [w, road], at: C, mu: 0.3}"),
    "wheel in a drum that may slip": ("O: [$x m, $y m], C: {from: O, distance: 2 m, angle: $a deg}, "
                                      "B: {from: O, distance: 2 m - $r m, angle: $a deg}",
                                      "d: {disk: O, radius: 2 m}, b: {disk: B, radius: $r m}", "",
                                      "contact: {between: [d, b], at: C, mu: 0.3}"),
    "particle in a drum": ("O: [$x m, $y m], B: {from: O, distance: 2 m, angle: $a deg}",
                           "d: {ring: O, radius: 2 m}, P: {particle: B}", "wall: {center: O, radius: 2 m, body: d}",
                           "contact: {between: [P, wall], at: B, mu: 0.3}"),
    "rod over a wheel": ("O: [$x m, $y m], C: {from: O, distance: $r m, angle: $a deg}, A: {from: C, distance: 1 m, angle: $a deg + 90 deg}, "
                         "B: {from: C, distance: 2 m, angle: $a deg - 90 deg}", "AB: {rod: [A, B]}, d: {disk: O, radius: $r m}", "",
                         "contact: {between: [AB, d], at: C, mu: 0.3}"),
    "rod over a fixed log": ("O: [$x m, $y m], C: {from: O, distance: $r m, angle: $a deg}, A: {from: C, distance: 1 m, angle: $a deg + 90 deg}, "
                             "B: {from: C, distance: 2 m, angle: $a deg - 90 deg}", "AB: {rod: [A, B]}", "trunk: {center: O, radius: $r m}",
                             "contact: {between: [AB, trunk], at: C, mu: 0.3}"),
    "rod over a carried log": (f"{POINTS}, O: [$x m, $y m], C: {{from: O, distance: $r m, angle: $a deg}}, "
                               "A: {from: C, distance: 1 m, angle: $a deg + 90 deg}, B: {from: C, distance: 2 m, angle: $a deg - 90 deg}",
                               f"{CAR}, AB: {{rod: [A, B]}}", "trunk: {center: O, radius: $r m, body: car}",
                               "contact: {between: [trunk, AB], at: C, mu: 0.3}"),
    "end of a rod on a rod": ("A: [0, 0], B: [2 m, $y m], C: [1 m, 3 m], D: {from: A, towards: B, distance: $r m}",
                              "AB: {rod: [A, B]}, CD: {rod: [C, D]}", "", "contact: {between: [CD, AB], at: D, mu: 0.3}"),
    "crate on a floor": ("C: [$x m, 0], G: [$x m, $r m]", "c: {plate: G, width: 1 m, height: 2*($r m)}", "floor: {through: C, angle: 0 deg}",
                         "contact: {between: [c, floor], at: C, mu: 0.3}"),
    "smooth crate": ("C: [$x m, 0], G: [$x m, $r m]", "c: {plate: G, width: 1 m, height: 2*($r m)}", "floor: {through: C, angle: 0 deg}",
                     "contact: {between: [c, floor], at: C, mu: 0}"),
    "crate on a moving deck": (f"{POINTS}, C: [$x m, 0], G: [$x m, $r m]", f"{CAR}, c: {{plate: G, width: 1 m, height: 2*($r m)}}",
                               "deck: {through: C, angle: 0 deg, body: car}", "contact: {between: [c, deck], at: C, mu: 0.3}"),
    "crate on a carried belt": (f"{POINTS}, C: [$x m, 0], G: [$x m, $r m]", f"{CAR}, c: {{plate: G, width: 1 m, height: 2*($r m)}}",
                                "deck: {through: C, angle: 0 deg, body: car, speed: 2 m/s}",
                                "contact: {between: [c, deck], at: C, mu: 0.3}"),
    "crate on a crate": ("C: [$x m, 0], G: [$x m, $r m], H: [$x m + 0.1 m, -1 m]",
                         "c: {plate: G, width: 1 m, height: 2*($r m)}, d: {plate: H, width: 3 m, height: 2 m}", "",
                         "contact: {between: [c, d], at: C, friction: 5 N}"),
    "wheel on a crate": ("C: [$x m, 0], G: [$x m, $r m], H: [$x m + 0.1 m, -1 m]",
                         "c: {disk: G, radius: $r m}, d: {plate: H, width: 3 m, height: 2 m}", "",
                         "contact: {between: [d, c], at: C, mu_s: 0.3, mu_k: 0.2}"),
    "block on a table": (f"{POINTS}, P: [$x m, $y m]", f"P_block: {{particle: P}}, {CAR}", "", "flat: {between: [P_block, car], mu: 0.3}"),
    # --- ropes -------------------------------------------------------------------------------------------------------
    "rope between bodies": ("A: [$x m, $y m], B: [$z m, 1 m], C: [2 m, $x m], D: [$y m, 3 m]", "AB: {rod: [A, B]}, CD: {rod: [C, D]}", "",
                            "rope: {path: [A, D]}"),
    "rope from the ground": ("A: [$x m, $y m], B: [$z m, 1 m], O: [0, 4 m]", "AB: {rod: [A, B]}", "", "rope: {path: [O, B]}"),
    "parallel rope of one part": ("A: [$x m, $y m], B: [$z m, 1 m], C: [2 m, 5 m], D: [$z m, 3 m]", "AB: {rod: [A, B]}, CD: {rod: [C, D]}", "",
                                  "rope: {path: [B, D], along: 90 deg}"),
    "rope over a pulley": ("A: [-1 m, -$x m], B: [2 m, -$z m], D: [0.2 m, $y m]", "p: {disk: D, radius: $r m}, P: {particle: A}, Q: {particle: B}",
                           "", "rope: {path: [A, over D, B]}"),
    "rope over and under": ("A: [-2 m, -$x m], B: [5 m, $z m], D: [0 m, $y m], E: [3 m, 0.1 m]",
                            "p: {disk: D, radius: 0.5 m}, q: {disk: E, radius: 0.4 m}, P: {particle: A}, Q: {particle: B}", "",
                            "rope: {path: [A, over D, under E, B]}"),
    "parallel rope": ("A: [0, 0], B: [2 m, -$x m], D: [1 m, 3 m]", "p: {disk: D, radius: 1 m}, P: {particle: A}, Q: {particle: B}", "",
                      "rope: {path: [A, over D, B], along: 90 deg}"),
    "rope by a small pulley": ("A: [-1 m, -$x m], B: [2 m, -$z m], C: [0, 1 m], D: [0.2 m, $y m]", "CD: {rod: [C, D]}, P: {particle: A}, Q: {particle: B}",
                               "", "rope: {path: [A, C, B]}"),
    "rope on a drum": ("G: [$x m, $y m], T: {from: G, distance: $r m, angle: $a deg}, B: {from: T, distance: 2 m, angle: $a deg - 90 deg}",
                       "d: {disk: G, radius: $r m}, P: {particle: B}", "", "rope: {path: [T on d, B]}"),
    "rope to a drum": ("G: [$x m, $y m], T: {from: G, distance: $r m, angle: $a deg}, B: {from: T, distance: 2 m, angle: $a deg + 90 deg}",
                       "d: {disk: G, radius: $r m}, P: {particle: B}", "", "rope: {path: [B, T on d]}"),
    "rope between drums": ("G: [0, 0], T: [0, $r m], S: [3 m, $r m], H: [3 m, $r m - 0.3 m]",
                           "d: {disk: G, radius: $r m}, e: {disk: H, radius: 0.3 m}", "", "rope: {path: [T on d, S on e]}"),
    "crossed rope between drums": ("G: [0, 0], T: [0, $r m], S: [3 m, $r m], H: [3 m, $r m + 0.3 m]",
                                   "d: {disk: G, radius: $r m}, e: {disk: H, radius: 0.3 m}", "", "rope: {path: [T on d, S on e]}"),
    "parallel rope on a drum": ("G: [0, 0], T: [$r m, 0], B: [$r m, -2 m]", "d: {disk: G, radius: $r m}, P: {particle: B}", "",
                                "rope: {path: [T on d, B], along: 90 deg}"),
    "parallel rope from a drum over a pulley": ("G: [0, 0], T: [$r m, 0], D: [$r m + 0.5 m, 3 m], B: [$r m + 1 m, $y m]",
                                                "d: {disk: G, radius: $r m}, p: {disk: D, radius: 0.5 m}, P: {particle: B}", "",
                                                "rope: {path: [T on d, over D, B], along: 90 deg}"),
    "drum and pulley": ("G: [0, 0], T: [0, $r m], D: [3 m, $r m - 0.4 m], B: [5 m, -$y m]",
                        "d: {disk: G, radius: $r m}, p: {disk: D, radius: 0.4 m}, P: {particle: B}", "", "rope: {path: [T on d, over D, B]}"),
}  # fmt: skip


def instant_of(name: str, seed: int) -> Instant:
    """The scene of one template with random numbers."""
    points, bodies, surfaces, *joints = SCENES[name]
    rng = random.Random(f"{name} {seed}")
    numbers = {k: f"{rng.uniform(0.4, 1.6):.3f}" for k in "xyzr"}
    numbers |= {"a": f"{rng.uniform(100, 170):.1f}", "b": f"{rng.uniform(60, 85):.1f}"}
    lines = ["title: drawn at random", f"points: {{{points}}}", f"bodies: {{{bodies}}}"]
    lines += [f"surfaces: {{{surfaces}}}"] if surfaces else []
    lines += ["joints:", *(f"  - {j}" for j in joints)]
    lines += ["plane: horizontal", "instant: [at rest]", f"find: {{x: theta({bodies.split(':')[0]})}}"]
    problem, wrong = load_text(Template("\n".join(lines) + "\n").substitute(numbers))
    assert problem is not None, [d.message for d in wrong]
    assert not wrong, [d.message for d in wrong]
    return make_instant(problem, (), (), {}, False)


def choices_of(instant: Instant) -> Iterator[list[tuple[Joint, Mode]]]:
    """Every combination of modes."""
    for chosen in itertools.product(*(modes for _, modes in instant.modes)):
        yield [(joint, mode) for (joint, _), mode in zip(instant.modes, chosen, strict=True)]


def jets_of(instant: Instant, chosen: list[tuple[Joint, Mode]], places: dict[str, Place]) -> list[TimeJet]:
    poses = NearPoses(instant.scene.valuations[0], places)
    found = []
    for joint, mode in chosen:
        for residual in joint.residuals(instant.scene, mode):
            value = residual.of(poses)
            found += [tidied(j) for j in ((value.x, value.y) if isinstance(value, Vec) else (value,))]
    return found


def places_of(instant: Instant, speeds: list[Decimal]) -> dict[str, Place]:
    value: Valuation = instant.scene.valuations[0]
    places, column = {}, 0
    for name, body in instant.scene.bodies.items():
        turn = column + 2 if body.rigid else None
        x, y, *spin = speeds[column : column + (3 if body.rigid else 2)]
        center = Vec(value(body.center.x), value(body.center.y))
        places[name] = Place(center, Vec(x, y), spin[0] if spin else ZERO, (column, column + 1, turn))
        column += 3 if body.rigid else 2
    return places


def allowed(instant: Instant, chosen: list[tuple[Joint, Mode]], rng: random.Random) -> list[Decimal]:
    """Random velocities under which no residual changes."""
    width = sum(3 if b.rigid else 2 for b in instant.scene.bodies.values())
    jets = jets_of(instant, chosen, places_of(instant, [ZERO] * width))
    solved = solve([[*(jet.slopes.get(i, ZERO) for i in range(width)), jet.rate] for jet in jets], width)
    assert solved.conflict is None
    speeds = list(solved.values)
    for vector in solved.null.values():
        share = Decimal(rng.randint(-200, 200)) / 100
        speeds = [s + share * v for s, v in zip(speeds, vector, strict=True)]
    return speeds


def facts_of(instant: Instant, chosen: list[tuple[Joint, Mode]], places: dict[str, Place]) -> tuple[list[Line], Decimal]:
    """The rows of accelerations that the facts state, and the largest velocity that they forbid."""
    twists = {name: (p.velocity, p.spin) for name, p in places.items()}
    centers = {name: p.center for name, p in places.items()}
    assembly = Assembly(instant.scene.valuations[0], centers, instant.scene.rigid, twists)
    forbidden = [ZERO]
    for _, mode in chosen:
        for joining in mode.facts.joinings:
            assembly.joining(joining)
            point = assembly.number(joining.point)
            gap = assembly.point_velocity(joining.mover, point) - assembly.point_velocity(joining.base, point)
            if joining.drift is not None:
                gap = gap - assembly.number(joining.drift)
            forbidden += [gap.dot(d) for d in assembly._forbidden(joining)]
            if not joining.turns and all(instant.scene.rigid(b) for b in (joining.mover, joining.base)):
                forbidden.append(assembly.spin(joining.mover) - assembly.spin(joining.base))
        for row in mode.facts.rows:
            assembly.rows.append(assembly.row(row))
            forbidden.append(assembly.row_speed(row))
        if mode.sliding is not None and mode.direction == 0:
            forbidden.append(assembly.row_speed(mode.sliding))
    columns = {i: places[b].columns[("x", "y", "turn").index(part)] for (b, part), i in assembly.columns.items()}
    rows = [{CONSTANT if j < 0 else columns[j]: c for j, c in row.items() if c} for row in assembly.rows]
    return rows, max(abs(f) for f in forbidden)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", SCENES)
def test_facts_and_residuals_agree(name: str, seed: int) -> None:
    instant = instant_of(name, seed)
    rng = random.Random(seed)
    for chosen in choices_of(instant):
        words = ", ".join(m.name for _, m in chosen)
        places = places_of(instant, allowed(instant, chosen, rng))
        jets = jets_of(instant, chosen, places)
        assert all(abs(jet.rate) < Decimal("1e-45") for jet in jets)
        assert all(abs(jet.value) < Decimal("1e-45") for jet in jets)
        rows, forbidden = facts_of(instant, chosen, places)
        assert forbidden < Decimal("1e-40"), f"{words}: the facts forbid a velocity that the geometry allows"
        ours, theirs = Echelon(), Echelon()
        for jet in jets:
            assert ours.add({**jet.slopes, CONSTANT: jet.second}) < Decimal("1e-40")
        for row in rows:
            assert theirs.add(row) < Decimal("1e-40"), f"{words}: the facts contradict themselves"
        assert len(ours.pivots) == len(theirs.pivots), f"{words}: {len(theirs.pivots)} facts, {len(ours.pivots)} residuals"
        for row in rows:
            remainder = ours.add(row)
            assert remainder < Decimal("1e-35"), f"{words}: another acceleration, by {remainder:.3g} of its size"
            assert len(ours.pivots) == len(theirs.pivots), f"{words}: the facts forbid another motion"


def test_every_joint_is_tried() -> None:
    tried = {joint.split(":")[0] for scene in SCENES.values() for joint in scene[3:]}
    assert tried | {"impact"} == set(members("joints"))
