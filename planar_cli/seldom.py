"""Modules of planar that at most half of the pages need; others take functions from them.

To load a module takes 0.2 ms. These are loaded by the first call of a function that another module took from them, so
that an ordinary page does without most of them (`later`). A module belongs here where its functions are called seldom;
one that takes a class or a constant from it loads it at once, and does best to load seldom itself.
"""

from __future__ import annotations

IN_FOLDERS = {
    "calculus": """
        antiderivative curve_plain deciding forcing pieces polish
    """,
    "equation": """
        curves determined driven_rest driving led line_names machine nearness of_all on_two_points polar
        product_to_sum quadrature tipping trigonometry turning ways_told
    """,
    "motion": """
        replacing
    """,
    "problem": """
        blows gaps headings led_by_ground logarithms no_number part_names relaxed rod_ends said_here show
        slopes tips whose_load yaml_errors
    """,
    "report": """
        about_fixed_point along_path angles_alike another_equation another_point asked_energy
        asked_in_general at_one_state axes_asked between_led blow_check blow_limits by_formula_above by_geometry
        centre_check centre_reasons changes closed_letters coincident cosine_check curvature damper_rates
        discussion durations effects energy_check exam extreme_rates first_second fixed_lines free_motions
        grooves harmonic_check hidden_data inertia_check law_check laws_solved letter_check meanings
        meeting_check modes motion_phrases nil_impulses on_circle only_reaction opened_sums origins
        oscillation_check parts passages passing polar_check presses projected raw_moments reciprocals
        rests_on results_once rolled_contacts rolled_speeds rope_ends rope_rates round_check shared_friction
        shown slip_senses slips_at_start small_deviations special_case stated_bounds stated_text stretches swallowed
        system_sum ties time_check track_check turn_check turned_diagrams turning_rates velocity_check vibrations
        what_happens what_it_needs with_units written_places
    """,
    "solve": """
        held states
    """,
    "solve.diagnosis": """
        beginning cases failures impacts meant no_value open_data placed words
    """,
    "solve.instant": """
        distribution impending limit_conditions modes_search named_parts one_way parting pivots
        pressed_across reasons recognised scan seek several_roots stationary stationary_point tangents
        told_places translating truth virtual_power
    """,
    "solve.regimes": """
        mode_dates
    """,
}
"""The modules of each folder."""
SELDOM = tuple(f"planar_cli.{folder}.{name}" for folder, names in IN_FOLDERS.items() for name in names.split())
