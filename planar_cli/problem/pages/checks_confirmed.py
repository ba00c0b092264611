"""Checks: what confirms an answer, and what is not an answer.

One instant: the solution is put into all its equations at sixty digits, and the same scene is assembled once more as a
plain multibody system from positions alone. If the two differ, nothing is printed.

A motion is followed once more, step by step, from facts of which the equations of the solution know nothing: places
that the joints keep, and forces of the loads. What it takes from the solution is what the file leaves to equations:
constants under `unknowns`, a restitution that a velocity just after tells, velocities of a start that a later state
tells. Letters have numbers that are drawn for them. Energy, linear momentum and angular momentum must add up over every
part of it. Then every find is compared:

  agrees          to six digits, or to what the steps are good for: counted with --verbose
  differs         nothing is an answer: the error (PL720) names the find, both values, and where; exit status 3
  not compared    named on the line of checks; --verbose and JSON (`confirmed: false`, `unconfirmed`) tell why

What can not be compared, and when:
  - curves, and periods, frequencies and stability, which belong to no single motion
  - an equilibrium, which lies beside the motion; a place that is only approached (`x = infinity`)
  - in letters, a state that is told by a quantity over a span, such as `path_length(P) @ 1->2 = s`
  - states that `method: energy` relates and no motion joins
  - what begins in an unstable equilibrium, and what has died out into rounding
  - bodies without mass that nothing drives, forces of redundant constraints that decide, a singular position

Answers that are read off a motion that was followed, because no equation gives them, have an error that a second run
estimates, and say so; nothing else confirms them. See also: planar explain simulate.
"""
