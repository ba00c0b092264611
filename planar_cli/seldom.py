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
    "equation": """
        cancelled_angles curves determined driven_rest driving led line_names machine meeting nearness of_all
        on_two_points polar product_to_sum quadrature tipping trigonometry turning waves ways_told
    """,
    "homework": """
        curves
    """,
    "motion": """
        afterwards corners hanging replacing resting settling unstable
    """,
    "problem": """
        blows fixed_ends gaps headings led_by_ground logarithms no_number part_names relaxed rod_ends said_here
        show slopes tips whose_load yaml_errors
    """,
    "report": """
        about_fixed_point across_the_way along_path angles_alike another_equation another_point antiderivatives
        asked_energy asked_in_general at_one_state axes_asked between_led blow_check blow_limits by_ends
        by_formula_above by_geometry centre_check centre_reasons centre_speeds centres_put_in changes closed_letters
        coincident common_centre cosine_check curvature damper_rates data_of_states discussion driving_speed durations
        effects energy_check energy_of_groups evaluated_integrals exam extreme_rates first_second fixed_lines
        free_motions gathered given_momenta grooves harmonic_check hidden_data inertia_check inside_integrals
        integrated law_check laws_solved letter_check meanings meeting_check modes modes_of_blows motion_phrases
        nil_impulses on_circle on_ellipse only_reaction opened_sums origins oscillation_check parts passages passing
        points_by_bodies polar_check presses products projected put_in put_into raw_moments reciprocals rests_on
        results_once rolled_contacts rolled_parts rolled_speeds rope_ends rope_rates round_check shared_friction
        shown slip_senses slips_at_start small_deviations special_case speeds_of_momenta squared standing
        state_words stated_bounds stated_text stretches swallowed system_sum ties time_check track_check
        turn_check turned_diagrams turning_axes turning_back turning_rates turning_values velocity_check
        vibrations what_happens what_it_needs with_units works written_places
    """,
    "simulate": """
        heat stops
    """,
    "solve": """
        held only_just states within_a_turn
    """,
    "solve.between": """
        alternatives branch_order departed determined_part energies impulses inside_integrals integrated
        linear_parts near_rest one_sense root_beside span_integrals span_rates
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
