"""The errors and warnings of the package, and the form of their messages.

Every input error is built by one class from the same four parts, so that each is one sentence
that names the field, its value, the condition it breaks and the remedy.
"""

from __future__ import annotations

import contextlib
import difflib
import warnings
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

# A four-letter word with one letter wrong or two swapped scores 0.75; "aluminium" against "unobtainium" scores 0.6.
_CLOSE = 0.7


class NonhertzError(Exception):
    """Base class of all errors that this package raises on purpose."""


class InputError(NonhertzError, ValueError):
    """A value that cannot be used.

    Parameters
    ----------
    field : str
        Name of the input as the user wrote it, such as ``"diameter"`` or ``"body.a.length"``.
    value : object
        The value given.
    condition : str
        The condition, phrased to follow "must": ``"be positive"``.
    remedy : str
        What to do about it, a clause without a full stop.

    Examples
    --------
    >>> str(InputError("length", -5.0, "be positive", "give the distance between the side faces in mm"))
    'length = -5.0 must be positive: give the distance between the side faces in mm.'
    """

    def __init__(self, field: str, value: object, condition: str, remedy: str) -> None:
        self.field = field
        self.value = value
        self.condition = condition
        self.remedy = remedy
        super().__init__(field, value, condition, remedy)

    def __str__(self) -> str:
        # Python has no better words for a table of a file, an option without a value, or what is missing.
        missing = self.value is None and (self.field.startswith("--") or self.condition.startswith("be given"))
        wordless = missing or isinstance(self.value, Mapping) or (self.field.startswith("--") and self.value is True)
        problem = self.field if wordless else f"{self.field} = {shown(self.value)}"
        return f"{problem} must {self.condition}: {self.remedy}{'' if self.remedy.endswith('?') else '.'}"

    def within(self, place: str) -> InputError:
        """Return the same error with the field named inside ``place``, such as ``"body.a"``."""
        return self.about(_inside(place, self.field), self.value)

    def about(self, field: str, value: object) -> InputError:
        """Return the same error about a field of another name, or its value as the user wrote it."""
        return InputError(field, value, self.condition, self.remedy)

    @property
    def each(self) -> tuple[InputError, ...]:
        """The errors that this one stands for: itself."""
        return (self,)


class UnknownKeyError(InputError):
    """An unknown name.

    Parameters
    ----------
    field : str
        The name as the user wrote it.
    value : object
        The value given.
    meant : str
        The closest known name; empty if none is close.
    remedy : str
        What to do where none is close.
    noun, owner : str
        What kind of name it is, and what it belongs to.

    Examples
    --------
    >>> str(UnknownKeyError("lenght", 20.0, "length", "").within("body.a"))
    'Unknown key body.a.lenght. Did you mean body.a.length?'
    """

    def __init__(self, field: str, value: object, meant: str, remedy: str, noun: str = "key", owner: str = "") -> None:
        self.meant, self.noun, self.owner = meant, noun, owner
        super().__init__(field, value, f"be a known {noun}", remedy)

    def __reduce__(self) -> tuple[Any, ...]:  # so that it can be sent between processes
        return type(self), (self.field, self.value, self.meant, self.remedy, self.noun, self.owner)

    def __str__(self) -> str:
        what = f"Unknown {self.noun} {self.field or repr('')}{f' of {self.owner}' if self.owner else ''}"
        return f"{what}. Did you mean {self.meant}?" if self.meant else f"{what}: {self.remedy}."

    def within(self, place: str) -> UnknownKeyError:
        """Return the same error with both names inside ``place``."""
        error = self.about(_inside(place, self.field), self.value)
        error.meant = _inside(place, self.meant) if self.meant else ""
        return error

    def about(self, field: str, value: object) -> UnknownKeyError:
        """Return the same error about a field of another name or value."""
        return UnknownKeyError(field, value, self.meant, self.remedy, self.noun, self.owner)


class InputsError(InputError):
    """Several errors of one input; where only one can be shown it is the first.

    Without any, the mistake has been reported for another input, on which this one depends.
    """

    def __init__(self, errors: Iterable[InputError]) -> None:
        self._each = tuple(errors)
        first = self._each[0] if self._each else InputError("", None, "be valid", "correct what it depends on")
        super().__init__(first.field, first.value, first.condition, first.remedy)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._each,)  # so that it can be sent between processes

    def within(self, place: str) -> InputsError:
        """Return the same errors with their fields named inside ``place``."""
        return InputsError(error.within(place) for error in self._each)

    @property
    def each(self) -> tuple[InputError, ...]:
        """The errors."""
        return self._each


class CaseError(NonhertzError):
    """A case file that cannot be used, with everything that is wrong in it.

    Parameters
    ----------
    mistakes : iterable of str
        The mistakes, one sentence each.
    places : iterable of str
        The key of each mistake, such as ``"body.a.profile[1].radius"``; empty if it concerns the whole file.

    Examples
    --------
    >>> error = CaseError(["title = 3 must be text: put it in quotes.", "[load] must be given: add it."])
    >>> len(error.mistakes)
    2
    """

    def __init__(self, mistakes: Iterable[str], places: Iterable[str] = ()) -> None:
        self.mistakes = tuple(mistakes)
        self.places = tuple(places) or ("",) * len(self.mistakes)
        # All arguments, so that the error can be pickled and sent between processes.
        super().__init__(self.mistakes, self.places)

    def __str__(self) -> str:
        return "\n".join(self.mistakes)


class ConvergenceError(NonhertzError):
    """The solver stopped short of a solution; ``solution`` holds the state it had reached.

    Parameters
    ----------
    message : str
        One sentence for the user.
    solution : nonhertz.Solution
        The unconverged result, its ``status`` saying why the loop ended.
    """

    def __init__(self, message: str, solution: Any) -> None:
        self.message = message
        self.solution = solution
        # All arguments, so that the error can be pickled and sent between processes.
        super().__init__(message, solution)

    def __str__(self) -> str:
        return self.message


class Interrupted(KeyboardInterrupt):
    """A run that was stopped by Ctrl-C; ``solutions`` holds what had been solved.

    A script that does not catch it ends. It is not a `NonhertzError`, so that ``except Exception`` does not catch it
    either.

    Parameters
    ----------
    message : str
        One sentence on how far the run had come.
    solutions : nonhertz.Solutions or nonhertz.study.Sweep
        All cases; those that were not solved are among its ``failures``. For a sweep, the rows that are there.
    """

    def __init__(self, message: str, solutions: Any) -> None:
        self.message = message
        self.solutions = solutions
        # All arguments, so that the error can be pickled and sent between processes.
        super().__init__(message, solutions)

    def __str__(self) -> str:
        return self.message


class AccuracyWarning(UserWarning):
    """The solution has converged, but the model may be used beyond its validity.

    Its text is the first sentence of a finding; ``findings`` of the result has the whole text and the numbers.
    """


@contextlib.contextmanager
def without_accuracy_warnings() -> Iterator[None]:
    """Silence `AccuracyWarning` where the results show the same findings or they do not matter."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", AccuracyWarning)
        yield


def shown(value: object) -> str:
    """Return a value as messages show it: numbers plain and without rounding error.

    Examples
    --------
    >>> shown(20.000000000000004), shown((0.1 + 0.2, 1)), shown("5 mm")
    ('20.0', '(0.3, 1)', "'5 mm'")
    """
    try:
        text = repr(_round(value))
    except ValueError:  # Python refuses to print integers of thousands of digits
        text = f"<{type(value).__name__} too long to show>"
    return text if len(text) <= 60 else text[:57] + "..."


def nearest(word: object, known: Iterable[str]) -> str:
    """Return the known word that ``word`` may misspell or abbreviate; empty if none is close.

    Examples
    --------
    >>> nearest("lenght", ["length", "load"]), nearest("GJS-400", ["EN-GJS-400-15", "steel"])
    ('length', 'EN-GJS-400-15')
    >>> nearest("unobtainium", ["aluminium", "alumina"])
    ''
    """
    if not isinstance(word, str):
        return ""
    spelled = {name.lower(): name for name in known}
    part = word.lower()
    whole = [name for name in spelled if len(part) > 2 and (name.startswith(part) or f"-{part}-" in f"-{name}-")]
    matches = difflib.get_close_matches(part, spelled, n=1, cutoff=_CLOSE) or whole
    return spelled[matches[0]] if len(matches) == 1 else ""


def join_words(words: Iterable[str], last: str = "and") -> str:
    """Return words as a sentence lists them.

    Examples
    --------
    >>> join_words(["inner", "outer"]), join_words(["case", "bearing", "plan"], "or")
    ('inner and outer', 'case, bearing or plan')
    """
    *others, end = words
    return f"{', '.join(others)} {last} {end}" if others else end


def _inside(place: str, field: str) -> str:
    return f"{place}{'.' if field and field[0] not in '[,' else ''}{field}"


def _round(value: object) -> object:
    if hasattr(value, "item") and not hasattr(value, "__len__"):
        value = value.item()
    if type(value) is float:
        return float(f"{value:.12g}")
    # Only the beginning of a longer one is shown.
    return type(value)(map(_round, value[:60])) if type(value) in (list, tuple) else value  # type: ignore[index,call-arg]
