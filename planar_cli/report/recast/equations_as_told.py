"""The equations of a part as a page tells them, before any of it is written: what the system counts otherwise than a
student would, in the order in which one change rests on the other.
"""

from __future__ import annotations

from planar_cli.report.friction.rolls_at_state import with_rolling_told
from planar_cli.report.kinematics.own_accelerations import with_own_accelerations
from planar_cli.report.kinematics.polar_parts import with_polar_parts
from planar_cli.report.recast.across_speeds import with_across_speeds
from planar_cli.report.recast.alike_put_in import with_alike_put_in
from planar_cli.report.recast.asked_velocities import with_asked_velocities
from planar_cli.report.recast.flight_axes import with_flight_axes
from planar_cli.report.recast.free_pair import with_free_pair
from planar_cli.report.recast.known_put_in import with_known_put_in
from planar_cli.report.recast.line_of_blow import with_line_of_blow
from planar_cli.report.recast.offset_normals import with_offset_normals
from planar_cli.report.recast.on_ellipse import with_ellipse_coordinates
from planar_cli.report.recast.one_velocity import with_one_velocity
from planar_cli.report.recast.parts_before_blow import with_parts_before
from planar_cli.report.recast.single_forces import with_single_forces
from planar_cli.report.recast.speeds_of_constants import with_constants_for_speeds
from planar_cli.report.recast.tangent_letters import with_tangent_letters
from planar_cli.solve.solved_problem import PartSolution


def equations_as_told(part: PartSolution) -> PartSolution:
    """The part with distances for the couples of faces, one velocity of what does not rebound, rolling, what is known
    put in, and speeds of angles; with the letters of what is asked.
    """
    shared = with_rolling_told(
        with_one_velocity(with_flight_axes(with_constants_for_speeds(with_polar_parts(with_offset_normals(part)))))
    )
    shared = with_ellipse_coordinates(
        with_parts_before(with_own_accelerations(with_free_pair(with_asked_velocities(with_line_of_blow(shared)))))
    )
    return with_single_forces(with_tangent_letters(with_across_speeds(with_known_put_in(with_alike_put_in(shared)))))
