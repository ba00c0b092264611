"""Relations that give the size or the direction of a velocity: triangles of velocities with every number of solutions."""

from __future__ import annotations

import pytest
from planar_cli.errors import NoSolution
from planar_cli.homework.checking import parse
from planar_cli.solve.run import solve_problem
