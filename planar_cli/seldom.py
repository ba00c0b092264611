"""Modules of planar that at most half of the pages need; others take functions from them.

To load a module takes 0.2 ms. These are loaded by the first call of a function that another module took from them, so
that an ordinary page does without most of them (`later`). A module belongs here where its functions are called seldom;
one that takes a class or a constant from it loads it at once, and does best to load seldom itself.
"""

from __future__ import annotations

IN_FOLDERS = {
    "calculus": """
        antiderivative curve_algebra curve_numeric curve_plain curve_polar curves deciding forcing limits
        linear_in_speed pieces polish
    """,
    "equation.algebra": """
        machine product_to_sum quadrature trigonometry
    """,
    "equation.kinematics": """
        polar ways_told
    """,
    "equation.scene": """
        curves line_names meeting nearness of_all turning
    """,
    "equation.system": """
        driven_rest driving led on_two_points tipping
    """,
    "equation.values": """
        cancelled_angles determined waves
    """,
    "homework.checking": """
        curves
    """,
    "motion.follow": """
        afterwards corners unstable
    """,
    "motion.start": """
        hanging resting
    """,
    "motion.terms": """
        replacing
    """,
    "motion.trajectory": """
        settling
    """,
    "problem.implied": """
        rod_ends whose_load
    """,
    "problem.language": """
        logarithms no_number slopes
    """,
    "problem.nodes": """
        show yaml_errors
    """,
    "problem.scene": """
        blows fixed_ends gaps headings led_by_ground part_names relaxed tips
    """,
    "problem.sections": """
        said_here
    """,
    "report.answers": """
        asked_in_general by_ends by_formula_above discussion special_case
    """,
    "report.checks": """
        another_equation another_point blow_check centre_check cosine_check energy_check first_second
        harmonic_check inertia_check law_check letter_check meeting_check oscillation_check polar_check
        round_check system_sum time_check track_check turn_check velocity_check
    """,
    "report.document": """
        stated_text
    """,
    "report.energy": """
        centre_speeds common_centre energy_of_groups standing works
    """,
    "report.equations": """
        put_into squared turning_back
    """,
    "report.friction": """
        presses shared_friction slip_senses slips_at_start what_happens what_it_needs
    """,
    "report.given": """
        data_of_states driving_speed stated_bounds written_places
    """,
    "report.in_numbers": """
        closed_letters opened_sums put_in with_units
    """,
    "report.instant": """
        across_the_way asked_energy axes_asked extreme_rates on_circle
    """,
    "report.kinematics": """
        about_fixed_point along_path between_led centre_reasons coincident curvature fixed_lines grooves
        projected rolled_contacts rolled_parts rolled_speeds rope_ends ties turning_axes
    """,
    "report.kinetics": """
        angles_alike damper_rates gathered only_reaction parts raw_moments rope_rates
    """,
    "report.laws": """
        antiderivatives evaluated_integrals inside_integrals laws_solved passages passing products results_once
    """,
    "report.momentum": """
        blow_limits given_momenta modes_of_blows nil_impulses speeds_of_momenta
    """,
    "report.motion": """
        at_one_state centres_put_in integrated meanings shown
    """,
    "report.notation": """
        by_geometry durations hidden_data reciprocals
    """,
    "report.oscillation": """
        free_motions modes small_deviations vibrations
    """,
    "report.page": """
        effects exam rests_on turning_rates
    """,
    "report.recast": """
        on_ellipse
    """,
    "report.repeats": """
        turned_diagrams
    """,
    "report.words": """
        changes motion_phrases origins points_by_bodies state_words stretches swallowed turning_values
    """,
    "simulate": """
        heat stops
    """,
    "solve": """
        held only_just states within_a_turn
    """,
    "solve.between.branches": """
        alternatives branch_order departed determined_part integrated one_sense span_integrals
    """,
    "solve.between.equations": """
        energies impulses span_rates
    """,
    "solve.between.roots": """
        root_beside
    """,
    "solve.between.route": """
        inside_integrals
    """,
    "solve.between.told": """
        linear_parts near_rest
    """,
    "solve.curves": """
        natural_letters one_freedom rolled unsigned
    """,
    "solve.diagnosis": """
        beginning cases choosing directions_left_open driven_jumps failures false_inequalities held_in_blows
        impacts lacking limits_of_modes meant missed no_value open_data other_masses placed turns_off undated
        unheld words
    """,
    "solve.following": """
        by_ways continuation gaps
    """,
    "solve.impulsive": """
        oblique spans
    """,
    "solve.instant": """
        distribution impending limit_conditions modes_search named_parts one_way parting pivots pressed_across
        reasons recognised scan seek several_roots stationary stationary_point tangents told_places translating
        truth virtual_power
    """,
    "solve.regimes": """
        differentiated gains kept_radius mode_dates stated_places
    """,
}
"""The modules of each folder."""
SELDOM = tuple(f"planar_cli.{folder}.{name}" for folder, names in IN_FOLDERS.items() for name in names.split())
