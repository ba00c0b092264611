"""Names, numbers, units and signs.

Names
  A name is a letter, then letters, digits, `_`. All names of a file differ: values, points, surfaces, bodies, and
  names given to joints and loads. (A particle may share its own point's name, a disk or plate that of its centre;
  states and finds are apart.) Reserved are t, pi, ground, all, infinity, on, off, yes, no, true, false, null, the
  functions below, and the words of the grammar: at, in, is, just, during, equilibrium, largest, smallest, cw, ccw,
  stick, slip, apart, tip, taut, slack. `r(`, `v(`, `N(` … with a bracket are quantities; `r`, `v`, `N` alone are your
  own names. `e` is yours too; Euler's number is `exp(1)`.
  On a page the word of a Greek letter, from `alpha` to `omega` and `Gamma` to `Omega`, is the letter, ε by `epsilon`;
  what stands behind `_` is a subscript, `_prime` a stroke: `mu_k`, `omega_AB`, `v_prime` are μ_k, ω_AB, v′. Digits at
  the end are a subscript in typeset formulas. A phrase of several words, `rain_speed_seen`, stands as it is written.

Expressions
  + - * / ^ and brackets. Multiplication is always written `*`. Functions: sin cos tan asin acos atan sqrt exp log
  abs, of `30 deg` or of radians; log is the natural logarithm. `pi` and `infinity` are numbers, `t` is the time.

Units
  A unit follows a number or `)` after a space and has no space inside:
      2 N*m       (pi/4) rad/s       4 m/s^2 + 0.3 m/s^3 * t
  Units are put together from
      m mm cm km   kg g mg tonne   s ms min h   rad deg rev rpm   Hz kHz   N mN kN MN   Pa kPa MPa GPa   J kJ MJ
      W kW MW   in ft yd mi   lb slug   lbf kip   psi   hp   mph   1
  with `*`, `/` and `^`; a broken power stands in a bracket: `m^(1/2)/s^(3/2)`. After `/`, or with a `*` inside a
  longer expression, number and unit need brackets: `x^2/(2 m)`, `(2 N*m) + M`. The tonne is `tonne`; `lb` is a mass
  and `lbf` a force. There is no `%` and no degree sign. A number without a unit is a pure number; where a unit is due
  it is an error. Zero needs no unit. An inch is written `3 in`; `in ft/s` at the end of a find is the unit wanted,
  `in in` the inch.

Signs
  x right, y up, angles and rotations counterclockwise from +x. `cw` after a unit is a minus, `ccw` a plus:
  `6.186 rad/s^2 cw`. N and tension are positive when they press and pull. A force is the force *on* the body named; so
  are work and impulse. theta(b) and r(P).angle count turns, from the angle with which the file constructs the point:
  with B at `angle: 210 deg` from A, a rod [A, B] begins at 210 deg. All other angles lie in (-180, 180] deg.

Gravity
  `g` is 9.81 m/s^2 unless `given` says otherwise; in a file with `symbols` it stays a letter.

Printed units
  The unit after `in`; else that of `answers`; else SI units, or US customary ones when all of `given` is;
  where `given` has no units, when all of the file is.
"""
