"""What the worked solution of a problem costs, beside following its motion."""

from __future__ import annotations

from planar_cli.records import record


@record
class Solved:
    """One problem solved."""

    digits: int | None
    """To so many digits two independent roads agree; None where none are known."""
    seconds: float
    """With the import of what it needs."""
    why: str = ""
    """Why none are known."""

    @property
    def words(self) -> str:
        """As a sentence."""
        if self.digits is None:
            return f"`planar solve` has no digits to tell of its answers: {self.why}"
        return (
            f"`planar solve` takes {self.seconds:.2g} s and is certain of {self.digits} digits, however many are asked."
        )
