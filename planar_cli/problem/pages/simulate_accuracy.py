"""Simulation: a scene followed in numbers, and what accuracy costs.

planar simulate FILE
  The motion begins in the first state of the file, or in its instant: places as drawn, those that are written with
  coordinates as that state says, velocities from its relations and `at rest`. What is not told is asked for
  (PL704), and a relation that the drawing contradicts is an error (PL609). Later states are looked for on the way,
  in the order of the file; the finds are answered at them, each with an estimated error from a second, finer run.
  Finds without a state, or those of `-q`, are the columns of a table; without any these are the places of all
  bodies.

  What happens is found, not assumed: a contact sticks, slips, tips, parts and strikes again, a rope slackens and jerks
  taut, a spring that acts one way takes hold. An `impact` without `during` acts whenever its bodies meet. Impacts
  without number (a ball that comes to rest) are summed up. Where rigid bodies with dry friction have no motion, or
  several, that is said with the time and the joint (PL700, PL701); a singular position likewise (PL702).

    --until '10 s'           to there; else to the last state, or some characteristic times
    --stop 'y(ball) = 0'     ends there; may be repeated
    -q 'v(B).mag in km/h'    a column; -q 'E=KE(all) + PE(all)' names it
    --at '0.5 s' --rows 51   which rows
    --output csv|json|npz    for programs; -o FILE
    --tolerance 1e-11        of one step, in parts of the scene's own scales
    --integrator radau       one of the shelf; left out, by the scene: explicit, implicit where it is stiff
    --set 'm=2 kg'           a number for a letter or an unknown
    --effects                what the scene calls for, line by line, and what one evaluation costs
    --without friction       also run without an effect, a load or a joint, by kind or name; dashed in a plot
    --case NAME              one case of the file
    --plot motion.svg        a picture too (or .png); `--plot-of` says of what, and may be repeated:
      --plot-of time         the columns of the table over the time, with a dot at each state; as it is without
      --plot-of path         the ways of bodies and points, x and y in one scale; `-q 'r(P)'` for some of them
      --plot-of phase        the rate over each coordinate, ω over θ of what turns; `-q 'theta(b)'` for some of them
      --plot-of energy       kinetic, potential and spring energy, what is dissipated and supplied, and their sum,
                             kinetic + potential + spring + dissipated - supplied, which stays the same
    --animate motion.html    the motion as it goes on (or .svg): plays again and again in any browser, without script
                             and network, in real time where that can be seen; of several cases the first, or `--case`
      --speed 0.1            so many times as fast as it is

planar accuracy FILE
  For each integrator and tolerance: the error against a reference at the limit of machine numbers, the error that was
  estimated, energy error, drift of the joints, evaluations and time; a diagram of error over time; what to choose for
  3, 6 and 10 digits; how a change of one unit in the last place grows, and the time beyond which digits mean nothing.
  `--peers` adds what else is installed. A folder gets one line a file.
"""
