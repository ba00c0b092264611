"""The keys at the top of a problem file.

  title, text        words; `text` is what the student reads: under `text: >-` an empty line begins a new paragraph, and
                     `{m}` stands for the value of the given name m
  source, note       words: where the problem comes from; how the answers were found
  plane              `vertical` (weight acts, -y) or `horizontal`; required where weight or a motion with mass matters
  given              known, with a number: a value, or an expression of names
                         given: {m: 50 kg, b: 2*l, g: 1.62 m/s^2}
  symbols            known, kept as letters: name: unit (`1` = pure number). They are positive; angles lie between 0 and
                     90 deg. The answer is then a formula.
                         symbols: {L: m, e: 1}
  unknowns           constants to be solved for: name: unit
                         unknowns: {F: N, beta: deg}
  assume             relations between names that hold by choice
                         assume: [a < g, b < l]
  coordinates        positions that vary, and with which points are written: name: unit; planar explain coordinates
                         coordinates: {theta: deg}
  points, surfaces,  the scene: planar explain points, planar explain bodies
  bodies
  joints, loads      lists of one-key entries: planar explain joints, planar explain loads
                         joints:
                           - pin: {at: A, between: [ground, AB]}
  motion             relations that hold all the time (or `during` a span), so that they may be differentiated
                         motion: [omega(OB) = 2 rad/s]
  instant            relations that hold at the one instant asked about
                         instant: [at rest]
  states             several instants, name: list of relations; never beside `instant`
                         states: {1: [at rest], 2: [theta = 0]}
  find               name: quantity, expression or relation, with `in unit` if wanted
                         find: {v: v(B).mag @ 2 in km/h}
  cases              name: any keys above, laid over the file: planar explain cases
  answers            what a key says, by find name: planar explain answers
  tolerance          the relative tolerance of the answers: 0.01
  method             the principle to use, and no other: planar explain methods
  variants           values for variants: {m: {from: 1 kg, to: 5 kg, step: 0.5 kg}, l: [3 m, 4 m]}; planar explain
                     variants
  figure             {hide: [W]}: names that figures do not show

Words that contain `: ` or ` #` go on indented lines below `>-`:

    text: >-
      A rod, hinged at A: find its acceleration.

No key is empty, none is `null` or `~`, and there are no anchors and tags of YAML.
"""
