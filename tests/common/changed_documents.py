"""Documents with any value anywhere, as JSON has them."""

import copy
from typing import Any

from hypothesis import strategies as st

KNOWN = ["steel", "crown", "ring", "5 mm", "1e999 m", "auto", "none", "mirror", "series", "plane-strain", "measured"]
SCALARS = st.one_of(
    st.floats(allow_nan=False, allow_infinity=False), st.integers(-(2**70), 2**70), st.booleans(),
    st.text(max_size=5), st.sampled_from(KNOWN),
)  # fmt: skip
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(st.text(max_size=5), inner, max_size=3)),
    max_leaves=5,
)


def places(value: Any, place: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Return the ways to all that is in a document."""
    keys: Any = list(value) if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ()
    return [place] * bool(place) + [inner for key in keys for inner in places(value[key], (*place, key))]


def changed_documents(document: dict[str, Any]) -> st.SearchStrategy[dict[str, Any]]:
    """Return documents that differ from one in a value, or in a key that nobody knows."""

    def changed(place: tuple[Any, ...], value: Any, extra: str) -> dict[str, Any]:
        made = copy.deepcopy(document)
        holder: Any = made
        for key in place[:-1]:
            holder = holder[key]
        holder[place[-1]] = value
        if isinstance(holder, dict) and extra:
            holder.setdefault(extra, value)
        return made

    return st.builds(changed, st.sampled_from(places(document)), VALUES, st.sampled_from(["", "", "x", "ü", "a.b"]))
