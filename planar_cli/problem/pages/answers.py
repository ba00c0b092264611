"""Answers: what a key says.

`answers` gives, by find name (of the file or its cases), what the solution must be:

    answers:
      alpha: 6.186 rad/s^2 cw                   a number with its unit; cw is minus
      v: [3 m/s, -4 m/s]                        a vector
      periods: [1.23 s, 0.45 s]                 of several modes of oscillation, the slowest first
      T: m*g*(1 + 2*h/l)                        a formula, in files with symbols
      stays: true                               a relation: true or false
      state: slip                               a mode
      curve: x^2 + y^2 = (15 m)^2               a curve, in x and y; of a hodograph in vx and vy, or in x and y too;
                                                a spiral in r and theta: r = b*theta
      F: {value: 39.18 N, tolerance: 0.02}      with a tolerance of its own

What is found agrees when it lies within one per cent of what is stated, a vector as a whole; `tolerance: 0.001` at
the top of the file sets that for all its answers. A formula agrees when it has the same values, to all digits unless
numbers in it are rounded. Answers never say yes, no, on or off.
"""
