"""Values of given names from which variants of a problem are made.

    variants: {m: {from: 2 kg, to: 5 kg, step: 0.5 kg}, beta: [20 deg, 25 deg, 30 deg]}

or in `given` itself, where the first value is that of the file:

    given: {m: {from: 2 kg, to: 5 kg, step: 0.5 kg}, beta: {one_of: [20 deg, 25 deg]}, l: 3 m}

A range goes up from `from` to `to` by `step`, in the unit of `from`; a list holds any values. The solution of the file
does not need them; `planar key` of a homework set draws from them (planar explain homework). Write data that vary by
their names in the rest of the file, and as `{m}` in `text`:

    text: A block of mass {m} lies on a slope of {beta}.
"""
