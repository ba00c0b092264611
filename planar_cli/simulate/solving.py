"""What the worked solution of a problem costs, beside following its motion."""

from __future__ import annotations

from planar_cli.records import record


@record
class Solved:
    """One problem solved."""

    digits: int | None
    """To so many digits two independent roads agree; None where there is no solution."""
    seconds: float
    """With the import of what it needs."""
    why: str = ""
    """Why there is no solution."""

    @property
    def words(self) -> str:
        """As a sentence."""
        if self.digits is None:
            return f"`planar solve` gives no answer: {self.why}"
        return (
            f"`planar solve` takes {self.seconds:.2g} s and is certain of {self.digits} digits, however many are asked."
        )
