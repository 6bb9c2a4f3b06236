"""Loads, displacements and speeds of a bearing in the load cases of a REXS model."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from nonhertz.bearing.spectrum import shares_of_revolutions
from nonhertz.files.rexs import attributes as table
from nonhertz.files.rexs.attributes import number_of, word_of
from nonhertz.files.rexs.model import Attributes, Model

# Forces, or displacements where there are none, and the tilt, or the moment where there is none.
_CHOICES = (("radial", "radial_displacement"), ("axial", "axial_displacement"), ("tilt", "moment"))


@dataclass
class Loading:
    """The loads of a bearing in load cases: tables of a bearing file, and remarks on missing data.

    Attributes
    ----------
    load : dict
        The load of the first load case with loads of the bearing; empty if there is none.
    spectrum : list of dict
        Loads with the share of revolutions.
    turning : str
        "outer" if only the outer ring turns; else empty.
    sentences : list of str
        Remarks.
    """

    load: dict[str, Any] = field(default_factory=dict)
    spectrum: list[dict[str, Any]] = field(default_factory=list)
    turning: str = ""
    sentences: list[str] = field(default_factory=list)


def read_loading(model: Model, number: int, flipped: bool) -> Loading:
    """Return the loads of a bearing in a model, turned by half a turn about v if a row is flipped."""
    own = model.components[number].attributes
    cases = [(case[number], _time_share(model, case)) for case in model.load_cases if number in case]
    states = [(state, share) for state, share in (*cases, (own, None)) if _prescribed(state, flipped)]
    loading = Loading()
    first = next((state for state, _ in states if table.REVOLUTION_SHARE not in state), None)
    _put_speed(loading, {**own, **(first or {})})
    if first is None:
        return loading
    loading.load |= _prescribed(first, flipped)
    loading.spectrum = _spectrum([(state, share) for state, share in states if state is not own], own, flipped)
    if len(cases) > 1 and not loading.spectrum:
        remark = f"- loads are those of the first of {len(cases)} load cases; the others are left out"
        loading.sentences.append(remark)
    return loading


def _put_speed(loading: Loading, state: Attributes) -> None:
    inner, outer = (entry.number(state) or 0.0 for entry in table.SPEEDS)
    if inner or outer:
        loading.load["speed"] = abs(inner or outer)
    if outer and not inner:
        loading.turning = "outer"
    elif outer:
        loading.sentences.append("- both rings turn; here the outer one is at rest")


def _time_share(model: Model, case: dict[int, Attributes]) -> float | None:
    """Return the share of the operating time that a load case has."""
    units = (case[entry] for entry in case if model.components[entry].type == table.GEAR_UNIT)
    return number_of(next(units, {}), "%", table.TIME_SHARE)


def _spectrum(
    states: Iterable[tuple[Attributes, float | None]], own: Attributes, flipped: bool
) -> list[dict[str, Any]]:
    """Return the spectrum of load cases with a share of revolutions, or at least two with one of the time."""
    states = list(states)
    own_shares = [(state, number_of(state, "none", table.REVOLUTION_SHARE)) for state, _ in states]
    if any(share is not None for _, share in own_shares):
        return [_load_of(state, flipped) | {"share": share} for state, share in own_shares if share is not None]
    timed = [(_load_of({**own, **state}, flipped), time) for state, time in states if time]
    return _of_revolutions(timed) if len(timed) > 1 else []


def _of_revolutions(timed: list[tuple[dict[str, Any], float]]) -> list[dict[str, Any]]:
    """Return loads with their shares of revolutions, from those of the time."""
    whole = sum(time for _, time in timed)
    speeds = [load.get("speed") or 1.0 for load, _ in timed]
    shares = shares_of_revolutions([time / whole for _, time in timed], speeds)
    # In all other load cases the bearing turns without load.
    return [load | {"share": min(1.0, whole) * share} for (load, _), share in zip(timed, shares, strict=True)]


def _load_of(state: Attributes, flipped: bool) -> dict[str, Any]:
    speed = max((abs(entry.number(state) or 0.0) for entry in table.SPEEDS), default=0.0)
    return _prescribed(state, flipped) | ({"speed": speed} if speed else {})


def _prescribed(state: Attributes, flipped: bool) -> dict[str, Any]:
    """Return loads and displacements of a load case as in a bearing file; empty if there are none."""
    pairs = _chosen(state, _pairs(state))
    if flipped:
        pairs = {name: (a, -b) if name in table.PAIRS else (-a, b) for name, (a, b) in pairs.items()}
    return {name: _unpair(name, pair) for name, pair in pairs.items()}


def _pairs(state: Attributes) -> dict[str, tuple[float, float]]:
    """Return all forces, moments and displacements with two axes."""
    values: dict[str, dict[int, float]] = {}
    for entry in (*table.LOADS, *table.REACTIONS):
        value = entry.number(state)
        name, _, place = entry.key.removeprefix("load.").partition(".")
        if value is not None:
            values.setdefault(name, {}).setdefault(int(place or 0), value)
    return {name: (entry.get(0, 0.0), entry.get(1, 0.0)) for name, entry in values.items()}


def _chosen(state: Attributes, pairs: dict[str, tuple[float, float]]) -> dict[str, tuple[float, float]]:
    """Return the pairs that are prescribed, not results."""
    if table.PRESCRIBED in state:
        names = word_of(state, table.PRESCRIBED).split()
    else:
        names = [next((name for name in choice if any(pairs.get(name, ()))), "") for choice in _CHOICES]
    return {name: pairs[name] for name in names if name in pairs}


def _unpair(name: str, pair: tuple[float, float]) -> float | list[float]:
    """Return one number if a pair has only one, or only one axis."""
    if name not in table.PAIRS:
        return pair[0]
    usual = table.PAIRS[name]
    return list(pair) if pair[1 - usual] else pair[usual]
