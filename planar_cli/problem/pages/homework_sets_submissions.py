"""Homework: sets of problems, variants, sheets and keys, and submissions graded against them.

The set

A set is a file that lists problem files:

    problems:
      - slope.yaml                                     a path, as seen from the set file
      - {file: gears.yaml, name: gears, points: 4}     points of a problem, shared by its finds
      - {file: rod.yaml, points: {alpha: 3, A_x: 1}}   or of each find; else each counts 1
      - {file: stop.yaml, ask: {s: "the compression of the spring"}}    what a find asks, in your words
    text: Hand in by Friday.
    variants: {number: 30, seed: 7}                    without `number` as many as students are listed
    students: [s101, s102]                             the first has variant 1, the second variant 2, …
    tolerance: 0.01                                    relative; else that of each file, else one per cent
    sigfig: 3                                          within 0.51 of the last of three figures, not a tolerance
    figures: 3                                         so many significant figures are asked for on the sheets
    credit: {unit: 0.5, no_unit: 0, sign: 0, precision: 0.9, carried: 1}
    decimal_comma: true                                12,5 is twelve and a half

Only `problems` is needed; `title: Homework 3` and `text` head the sheets. A credit is the part of the points that is
given for the right number with a wrong unit, without a unit (else that is ungradable, and told so), with the wrong sign
or sense, with too few figures, and for what follows rightly from another wrong value of the student's own (1 unless
said otherwise). What is carried is the student's own value, also a vector, put into the equations of the worked
solution, alone or with the student's right values, so that a way by other equations may come to another number. It is
carried into each find that rests on it in these equations, in whatever order the finds stand in the file; of finds that
rest on each other, as the unknowns of one system do, into those that are asked later. A value of zero, or one that is
far off, carries nothing. Where one typical mistake explains all wrong numbers of a problem, it is told first; none of
them is carried then from what is asked later and found by the same system of equations.

Between states, speeds, times and places that follow from written equations (energy, momentum, constant acceleration)
carry into what rests on them. What is read off a motion that is followed in numbers, because no such equations give it,
is carried into the equations of a later case that uses it as `case.find`. Into it the motion itself carries: it is
followed again with an own value that is one of its data (`case.find` of an earlier case), or goes on with the own place
or velocity from the state at which that is asked. A motion of more than 20 000 evaluations is not followed again.

An answer with fewer than `figures` figures is told so, and has the credit for `precision`. With `decimal_comma` a
semicolon parts the components of a vector, `[3,5; -4] m/s`; a point is a decimal point in any case.

Variants

Values of given names stand in the problem file, under `variants` or in `given` itself, where the first is that of the
file (planar explain variants). A combination is taken only where the physics stays what it is: the same case (roll or
slip, taut or slack), the same signs, no answer that hangs on the last digits of a datum, and every typical mistake that
is clearly wrong with the values of the file, by three tolerances, clearly wrong too. Of up to eight variants each is
solved anew, of more the extremes, and each where one of these has no solution; that one is not handed out. What there
is to say of the variants `planar key` says, also which mistakes hardly change an answer and are graded right, as
`--tolerance-report` does. In `text`, `{m}` stands for the value of m; a name in braces that is not given is an error.

    planar validate set.yaml                     is anything wrong with the set or its problem files, and does each
                                                 sheet ask by names that a student reads?
    planar key set.yaml                          the key, on the terminal
    planar key set.yaml -o out --format html     a sheet and a key for each variant, and the key of all
    planar key set.yaml -o out --both            the key with the worked solutions too
    planar key set.yaml -o out --format pdf      for the printer (extra `pdf`); latex: sources to go on with
    planar key set.yaml -o out --export moodle   questions for a course system

A worked page is made for each variant by itself, on all cores, and takes as long as `planar solve` does: 300 variants
of a problem that takes a second are five minutes on one core. `--timeout` is for one page, and for solving one problem
with its variants. A key without worked solutions does not take the place of one that has them.

In a file with `symbols` the names of `given` stay letters in the key, which tells a variant both ways:
`(1 + e) √(3 g l) / (1 + 3 n) = 3 √(3 g l)/8`, or `= 0.5333 v_0 (v_0 in m/s)` where numbers with units are put in for
all but the letters, if a product comes of it. An answer may have the letters, their numbers, or some of each. Such a
file is solved once more with numbers in place of its letters; by these equations wrong formulas are diagnosed, and what
follows from own ones is carried.

A student learns the variant from the sheet: it stands in its title, in its file name, `sheet-07`, and in the example of
how to hand in. Where the set lists `students`, each has a sheet of his or her own, `sheet-07-anna`, with the key
`key-07-anna`, and need not write the variant. Sheets list the given values that do not stand in the text, keys those
that vary. Sheets and keys that an earlier run wrote to the folder are removed if nobody changed them since
(`.planar-key.json` there tells which they are).

The formats are markdown, html, latex, pdf, json and csv. A page of HTML is one file, whose formulas a browser sets by
itself; LaTeX compiles with pdflatex and xelatex. Sheets show the scene of each problem as it is given, with the values
of the variant: what is sought, as a place or a direction, is not in the figure. Worked solutions have their diagrams.
Figures of Markdown are files beside it, sheet-07-1.svg and so on; hand them out with the sheet. The same seed gives the
same files, byte for byte. A sheet as CSV can be filled in and handed in as it is.

Submissions

    student: s101
    variant: 3
    answers:
      slope: {a: 3.21 m/s^2, N: 17.0 N}
      gears.omega: 6.19 rad/s cw

as YAML or JSON, one file a student; or as CSV with the columns `problem,find,answer` (and `unit`), for a whole class
with `student` before them (and `variant`), or with a column `slope.a` for each find. Without `student` the name of the
file is the student, without `variant` the set's list tells it. Who is not in the list is graded by the `variant` that
stands there, and told so; without one nothing is graded. Of a set without a list the files are meant as they are.

What is typed: `12.5 N`, `1.25*10^1 N`, `5*sqrt(2) m/s`, `6.2 rad/s cw`, `9.81 m/s^2 down`, `[3, -4] m/s`, `5 m/s at -53
deg`, `3i - 4j m/s`, `yes`, `slips`, and `m*g*sin(beta)` where the file has `symbols`: else a number is asked. Any unit
of the right dimension will do (`g` where an acceleration is due is that of gravity, `lb` where a force is due the pound
of force), a sense of rotation in place of a sign, an angle up to whole turns, a formula in any form that is identical.
`4 m/s down the slope` is read where a component along a line is asked, or a vector in a problem with a slope; other
words behind a unit are not read, and that is told. On a horizontal guide or floor the sign of one number tells the
direction of a vector. `-`, `?` and `n/a` are no answer. A formula, with letters or with numbers, may be written as on a
page, `5/2 m g`, `√(3g/l)`, `\\frac{3}{8}\\sqrt{3gl}`, `√(2*9.81*(1 - cos 65°)) m/s`: between letters of the problem a
missing sign is a product, where that is the only reading; rounded numbers in it are right within the tolerance. A
number before letters may have its unit, `0.96 kg v_0` or `0.533 v_0 rad/m`; without one it counts in m, kg, s, or ft,
slug, s where the file does. In YAML `crank.v: [3, -4] m/s` needs no quotes, and a line that cannot be read, or has more
than 10 000 characters, costs that line alone.

    planar check --set set.yaml submissions/                       every student, and the class
    planar check --set set.yaml submissions/ --export gradebook -o out
    planar check --set set.yaml submissions/ --feedback texts      a text for each student, with nothing of the key
    planar check --set set.yaml submissions/ --results done.jsonl  goes on there when it is run again, and prints all
    planar check --set set.yaml --tolerance-report                 does 1 % fail who only rounds, in any variant, or
                                                                   pass a wrong model?
    planar check --set set.yaml --false-matches                    how often a random wrong number is diagnosed

Each find gets verdicts on value, unit, sign and precision; it is right, wrong, or ungradable with the reason. Where it
follows rightly from another wrong value of the student, `carried` is printed for wrong, and `partly right` where a
slip in unit, sign or figures leaves a part of the points. Of a vector the part that is asked is taken, and told. A
wrong number or formula that just one typical mistake gives, as far as the student wrote it out, is told so: 1.52 is
also 1.5159. A number of two figures tells of no mistake, unless the sheet asks for no more. `planar explain` lists the
mistakes, and the exports. Of several submissions of a student all are graded, and the last by the name of its file
counts in the average.

With `--student` nothing of the key is printed. `--shard 3/40` grades a part, `planar merge` puts the results of parts
together, `--cluster tcp://host:8786` grades on a dask cluster (extra `cluster`). A run that Ctrl-C breaks off tells how
many files are left and ends with 130; with `--results` the same command goes on there, and prints, reports and exports
those of before too.
"""
