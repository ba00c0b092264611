"""Blows: impacts, impulses, joints that take hold of moving parts or let go.

A blow takes no time. It stands between a state and one that is `just after` it: same place and time, other velocities.

    states:
      1: [v(ball).x = 3 m/s, v(ball).y = -4 m/s]
      2: [just after 1]
      3: [y(ball) = 0]

What can happen in a blow
  impact               two bodies strike each other: planar explain impact. Without `during` it may act in every blow
  impulse              a blow of given or sought size: planar explain impulse. Two bodies that push each other off (a
                       shot, a jump from a cart) have one each, of the same unknown magnitude and opposite directions
  a joint's `during`   a joint that starts at the state before the blow takes hold of parts that move: a bullet that
                       stays in a block (`weld: {…, during: 1->3}`), a rod caught at its end (`pin: {at: A, between:
                       [ground, rod], during: 2->4}`), a rope that jerks taut, wheels that are suddenly geared
                       (`rolling`). A pin or weld catches the point where it is then. A joint that ends lets go
  everything else      pins, guides, rolling, ropes and contacts that hold answer with impulses of their own. A contact
                       or a rope gives none by which it would pull or push: it parts, or goes slack. Friction of a
                       contact is at most mu times its normal impulse. Weights, springs and other finite forces have
                       no impulse

What is written
  For every body and group: momentum before + impulses = momentum after, along a direction or about a point; restitution
  along the common normal; what the joints demand of the velocities after it. A coefficient of restitution that is left
  out is one unknown more: state something of the velocities after the blow.

What is asked
  v(P) @ 2             velocities just after
  impulse(j) @ 1->2    the impulse of a joint, load or impact, a vector; `impulse(j/b)` on the body b
  KE(all) @ 1 - KE(all) @ 2   the energy lost; `heat(j) @ 1->2` that lost at one joint or impact
  work(f) @ 1->2       of an impulse: J · (v_1 + v_2)/2

Several contacts at once
  All impacts of one blow happen at the same time, each with its own coefficient of restitution (Newton's law at every
  contact). Bodies that touch in a row give another answer when they strike one after the other: then write one blow
  after the other, `3: [just after 2]`, `4: [just after 3]`, each impact with its `during`.

    title: Bullet that stays in a hanging block
    plane: vertical
    given: {l: 1.5 m, v_0: 480 m/s}
    points: {O: [0, 0], P: [0, -l]}
    bodies:
      block: {particle: P, mass: 2.4 kg}
      bullet: {particle: [0, -l], mass: 12 g}
    joints:
      - link: {between: [O, P], name: cord}
      - weld: {at: P, between: [block, bullet], during: 1->3}
    states:
      1: [block at rest, v(bullet).x = v_0, v(bullet).y = 0]
      2: [just after 1]
      3: [block at rest]
    find:
      v: v(block).x @ 2
      lost: KE(all) @ 1 - KE(all) @ 2
      phi: r(P/O).angle @ 3 - r(P/O).angle @ 1 in deg
    answers: {v: 2.38806 m/s, lost: 1375.52 J, phi: 36.2714 deg}
"""
