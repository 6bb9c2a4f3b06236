"""What a contact is subjected to: approach or load, and tilt or moment."""

from __future__ import annotations

from dataclasses import dataclass

from nonhertz.errors import InputError
from nonhertz.model.checks import finite, positive
from nonhertz.model.contact import Contact


@dataclass(frozen=True)
class Prescription:
    """The two quantities that are given, checked; the other two are results.

    Attributes
    ----------
    by_load, by_moment : bool
        Whether the load, else the approach, and the moment, else the tilt, are given.
    first : float
        Load Q [N] or approach delta [mm].
    second : float
        Moment T [N mm] or tilt gamma [rad].
    """

    by_load: bool
    by_moment: bool
    first: float
    second: float

    @classmethod
    def checked(
        cls, approach: float | None, load: float | None, tilt: float | None, moment: float | None
    ) -> Prescription:
        """Return the prescription of those that are not None.

        Raises
        ------
        InputError
            If there are too few, too many, or one is out of range.
        """
        refuse_unpaired(approach, load, tilt, moment)
        if load is not None:
            positive("load", load, "give the force in N that presses the bodies together")
        if approach is not None:
            finite("approach", approach, "give the approach in mm")
        if moment is not None:
            finite("moment", moment, "give the moment in N mm")
        if tilt is not None:
            finite("tilt", tilt, "give the tilt in rad")
        first = load if load is not None else approach
        second = moment if moment is not None else (tilt or 0.0)
        assert first is not None
        return cls(load is not None, moment is not None, float(first), float(second))

    def refuse_outside(self, contact: Contact) -> None:
        """Refuse a moment that no pressure between the ends of the bodies can have."""
        low, high = contact.interval
        if self.by_moment and self.by_load and not low < self.second / self.first < high:
            condition = f"keep moment / load between {low:g} and {high:g} mm, where both bodies are"
            raise InputError("moment", self.second, condition, "reduce it or raise the load")
        if self.by_moment and ((self.second > 0.0 and high <= 0.0) or (self.second < 0.0 and low >= 0.0)):
            condition = f"have the sign of the lever arms, which lie between {low:g} and {high:g} mm"
            raise InputError("moment", self.second, condition, "turn its sign")


def refuse_unpaired(approach: object, load: object, tilt: object, moment: object) -> None:
    """Refuse what is not one of approach and load, and at most one of tilt and moment; None is what is not given.

    Raises
    ------
    InputError
        If there are too few or too many.
    """
    if (approach is None) == (load is None):
        raise InputError("load", load, "be given where approach is not, and only there", "give load or approach")
    if tilt is not None and moment is not None:
        raise InputError("moment", moment, "not be given together with tilt", "give tilt or moment")
