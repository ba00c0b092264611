"""The shelf of commands: each module is one command of `planar`, of the module's name (`_` is written `-`).

A member is a module with a command called `command`, declared as `options.py` says or, where it need not start at once,
by click; the first line of its docstring is its help in `planar --help`. It is imported only when it is run. It returns
its exit status, or raises a `PlanarError`:

    0 solved, or all agree      1 something disagrees, or there is no solution      2 wrong usage, or a bad file
    3 not decided               4 a fault of planar itself
"""
