"""Figures and documents: pages with drawings as HTML, PDF and Markdown, figures as files, and pages that follow a file.

planar solve FILE --format html -o page.html
  One file with all that it needs: formulas in MathML, figures in SVG, no script and nothing from a network. Steps fold;
  it is light or dark as the browser is, for wide and narrow screens, and for paper: what is folded is printed too.
  Under the title stand the text of the file and the scene, then the solution.
  --format pdf             the same page on A4, by typst (`pip install '.[pdf]'`); the same file gives the same bytes
  --format latex           its source, for pdflatex, xelatex and lualatex; figures are TikZ (Debian: texlive-pictures)
  --format markdown        text with formulas between $ and $$, as GitHub, notebooks and Pandoc show them. With
                           `-o page.md` its figures are page-figures/1.svg and so on; on standard output it has none.
  --audience exam          without the text, as short as a key; `lesson`: with what each step is for
  Several files make one document. `planar key` and sheets of homework have these formats as well
  (`planar explain homework`).

Figures of a page
  the scene                as the file draws it: bodies, joints, springs, ropes, given lengths and angles, axes, and g
                           where there is weight. Of a motion it is drawn where the motion begins; later positions are
                           dashed, each with the name of its state. A body without a shape is a point or a block.
                           Where a long rope, floor or distance would make all else too small to be read, it is broken
                           (two strokes across it): not to scale along that line, which the figure says.
  diagrams                 beside each list of forces: on the left what acts (red), on the right what it amounts to, m a
                           and I α (blue), in the position in which the equations are written. An arrow points in the
                           sense in which the letter is counted; a negative result is a force the other way. Where the
                           sense is assumed its arrow is dashed, and under the figure stands which came out opposite.
                           Where moments are taken about a point C, it is in both diagrams, with the lines of action
                           that meet there. Of a blow: momentum before + impulses = momentum after, momenta green.
  polygons                 of velocities and accelerations, to scale: the vector equations of the page, v_B/A, v_rel and
                           a_cor among them; vectors along one line lie side by side. Of a motion: velocities in its
                           states; what is told of one state is drawn there
  vectors of a point       where components are asked for: v and a at the place of the point, with v_r and v_θ, a_t and
                           a_n, or x and y, to scale and in their real senses (|a_r| is the size of a negative one);
                           e_r and e_θ, e_t and e_n; r and θ from their zero; the path, as far as it is known
  curves of a point        a path and a hodograph that are asked for, as far as they go on: the point in its states,
                           and the velocities there from the pole o; each to a scale of its own
  instantaneous centres    where velocities are found or checked by I, or it is asked for: I, the perpendiculars to the
                           velocities, dashed, and these velocities, to one scale
  `figure: {hide: [W, Q]}` in the file keeps the names of points and bodies out of the scene.

planar draw FILE -o FOLDER
  Each figure as a file: NAME-scene.svg, NAME-BODY.svg for the diagrams of a body, NAME-velocities.svg,
  NAME-accelerations.svg, NAME-vectors_of_POINT.svg, NAME-curves_of_POINT.svg and
  NAME-centre_of_BODY.svg, with a number where there are several. `--format png` makes pictures of dots (`.[pdf]`).
  Curves over the time, and the motion as it goes on: `planar simulate --plot` and `--animate`
  (`planar explain simulate`).

planar watch FILE
  Solves the file each time it is saved, until Ctrl-C. While the file has mistakes the last good page stays, and the
  messages stand below it.
  -o page.html             open it in a browser: it loads itself again, with the messages at its head. At the end it is
                           written once more without that.
  -o page.pdf --format pdf and every other format; a file that cannot be solved leaves it as it is
"""
