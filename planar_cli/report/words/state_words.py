"""How a state is spoken of: where something holds, and what happens there."""

from __future__ import annotations

from planar_cli.solve.law import IN_THE_END

HAPPENS = ("it stops sliding", "it turns round", "it comes to the other side")
"""What happens at an instant; all other words say what holds up to it."""
ENDS = (
    ("is not stretched", "begins to be stretched"),
    ("is not compressed", "begins to be compressed"),
    ("is stretched", "is no longer stretched"),
    ("is compressed", "is no longer compressed"),
    ("the tension pulls", "the tension ceases to pull"),
    ("within its limit", "reaches its limit"),
    ("acts inside the face", "reaches the edge of the face"),
    ("are apart", "meet"),
    (" presses", " ceases to press"),
    (" press on", " cease to press on"),
)
"""What holds, and what happens where it ceases to hold."""


def place(state: str) -> str:
    """`at 2`; of a state whose name begins with that word, `in state at_8`."""
    return f"in state {state}" if state.startswith("at_") else f"at {state}"


def at(state: str, words: str = "") -> str:
    """The words before what holds at a state, as the beginning of a sentence; "" of what has neither name nor words.
    What happens there goes on with the sentence: `At 2 the tension ceases to pull`.
    """
    own = place(state) if state else ""
    own = own[:1].upper() + own[1:]
    if own and words == IN_THE_END:
        return f"{own} {words.removeprefix('in the end ')}:"
    joined = " " if any(end in words for _, end in ENDS) or words in HAPPENS else ", "
    told = joined.join(part for part in (own, words) if part)
    return f"{told}:" if told else ""


def turning(words: str) -> str:
    """Why a state was put in: what happens there, or what holds up to it."""
    if words in HAPPENS:
        return words
    for holds, end in ENDS:
        if holds in words:
            article = "the " if words.startswith("friction ") else ""
            return article + words.replace(holds, end).replace("≤", "=")
    return f"up to here {words}"
