"""How a solve ended, and the estimated errors of its numbers."""

from __future__ import annotations

import enum
from dataclasses import dataclass


class Status(enum.Enum):
    """How a solve ended; each member's value is the sentence that the user reads."""

    CONVERGED = "The solution satisfies every contact condition."
    ITERATION_LIMIT = "The iterations reached their limit before the contact conditions were met."
    STAGNATED = "The iterations could not reduce the residual any further."
    REFUTED = "The state in which the iterations ended does not meet the prescribed values."

    @property
    def label(self) -> str:
        """The member's name as files and tables write it, such as ``"converged"``."""
        return self.name.lower().replace("_", "-")


@dataclass(frozen=True)
class ErrorEstimate:
    """Estimated discretisation errors, relative, from the same solve on about half as many strips.

    Attributes
    ----------
    approach : float
        |error of approach| / penetration, since part of the approach may be made before the bodies touch; zero where
        the approach is prescribed.
    load : float
        |error of load| / load; zero where the load is prescribed.
    max_pressure : float
        |error of maximum pressure| / maximum pressure. Infinite where the maximum is at a corner of the profile within
        the contact: every refinement raises it without limit, so no error is defined.
    moment : float
        |error of moment| / (load times half the length of the strips); zero where the moment is prescribed.
    tilt : float
        |error of tilt| times half the length of the strips / penetration; zero where the tilt is prescribed.
    """

    approach: float
    load: float
    max_pressure: float
    moment: float
    tilt: float
