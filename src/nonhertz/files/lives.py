"""How long both bodies of a case last, as text and as files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from nonhertz.amounts import read_in
from nonhertz.files.results import key_by_key, plain
from nonhertz.findings import Finding, as_warnings, sentences
from nonhertz.life import Life, Overrolled, VolumeModel
from nonhertz.model.body import BODIES, BodyName
from nonhertz.result.solution import Solution
from nonhertz.result.tables import csv_text
from nonhertz.verdict import Verdict, given_verdict, of_loads, with_life

#: Units of the numbers; dimensionless ones are left out.
UNITS: dict[str, Any] = {
    "models": {
        "parameters": {"fatigue_limit": "MPa"},
        "damage": "MPa^exponent mm^(2 - depth_exponent), of iso-16281 none",
        "reference": "as damage",
        "million_revolutions": "10^6 revolutions",
    },
    "spectrum": {"load": "N", "tilt": "rad", "max_pressure": "MPa"},
}
_COLUMNS = ("body", "model", "y [mm]", "density")


@dataclass(frozen=True, eq=False)
class Assessment:
    """How long both bodies of a case last.

    Attributes
    ----------
    title : str
        Title of the case.
    rollers : int or None
        Number of rollers in the bearing.
    spectrum : tuple of pairs
        Solutions and their shares of the revolutions.
    lives : mapping of str to tuple of Life
        One life per model for each body, ``"a"`` and ``"b"``.
    notes : tuple of str
        Remarks in addition to the warnings of the lives.
    dent : Overrolled or None
        A dent that was rolled over.
    dents : mapping of str to float
        How many there are: keywords of `Overrolled.relative_life`.
    required : float or None
        The life that is asked for [10^6 revolutions].
    assumed : tuple of Finding
        What is assumed of the models, where the case leaves it out.
    """

    title: str
    rollers: int | None
    spectrum: tuple[tuple[Solution, float], ...]
    lives: Mapping[BodyName, tuple[Life, ...]]
    notes: tuple[str, ...] = ()
    dent: Overrolled | None = None
    dents: Mapping[str, Any] = field(default_factory=dict)
    required: float | None = None
    assumed: tuple[Finding, ...] = ()

    @property
    def dent_lives(self) -> dict[str, float]:
        """The life of the raceway with dents over that without, by every volume model."""
        if self.dent is None:
            return {}
        return {each.name: self.dent.relative_life(each, **self.dents) for each in self._volume_models}

    @property
    def judging_dents(self) -> VolumeModel:
        """The first volume model that is not of orthogonal shear, which hardly sees dents."""
        return min(self._volume_models, key=lambda each: each.stress == "orthogonal_shear")

    @property
    def _volume_models(self) -> list[VolumeModel]:
        return [life.model for life in self.lives["b"] if isinstance(life.model, VolumeModel)]

    @property
    def raceway(self) -> BodyName | None:
        """The body that a roller rolls on, whose life is given in revolutions; None if there is none."""
        ring = self.lives["b"][0].raceway
        return None if ring is None else ring.body

    @property
    def verdict(self) -> Verdict | None:
        """Whether the bodies bear their loads, the worst of all, and last as long as is asked for, by every model."""
        lives = [self.million_revolutions(number) for number in range(len(self.lives["b"]))]
        return with_life(of_loads(self.spectrum), min(filter(None, lives), default=None), self.required)

    @property
    def warnings(self) -> tuple[str, ...]:
        """The notes and all that was found, a sentence each."""
        return tuple(dict.fromkeys((*self.notes, *sentences(self.findings))))

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All that was found of the lives and of a dent, each once."""
        found = [] if self.dent is None else [*self.dent.findings]
        for life in (life for body in BODIES for life in self.lives[body]):
            found += life.findings
        return tuple(dict.fromkeys(found))

    def million_revolutions(self, number: int) -> float | None:
        """Return the life of the raceway by one of the models [10^6 revolutions], or None."""
        return self.lives[self.raceway or "b"][number].million_revolutions

    def over(self, other: Assessment, body: BodyName, number: int) -> float:
        """Return the ratio of a body's life by one of the models to that in another case [-]."""
        return self.lives[body][number].over(other.lives[body][number])


@read_in("si")
def as_object(found: Assessment, other: Assessment | None = None) -> dict[str, Any]:
    """Return lives, and those they are compared with, as plain numbers, text, lists and dictionaries.

    A number that is not finite is None.
    """
    compared = {} if other is None else {"compared_with": _own(other, found)}
    return _own(found) | compared | {"units": UNITS}


def as_table(found: Assessment) -> str:
    """Return the damage density along both bodies as CSV with a header of names and units."""
    rows = (
        [body, life.model.name, y, plain(density)]
        for body in BODIES
        for life in found.lives[body]
        for y, density in zip(life.y.tolist(), life.density.tolist(), strict=True)
    )
    return csv_text(_COLUMNS, rows)


@read_in("si")
def files(found: Assessment, other: Assessment | None) -> dict[str, str]:
    """Return the texts of life.json and life.csv, and of compared.csv if there is another case, by file name."""
    texts = {"life.json": key_by_key(as_object(found, other)) + "\n", "life.csv": as_table(found)}
    return texts if other is None else texts | {"compared.csv": as_table(other)}


def _own(found: Assessment, against: Assessment | None = None) -> dict[str, Any]:
    """Return the lives of one case, with those of another over them if there is one."""
    models = []
    for number, both in enumerate(zip(*(found.lives[body] for body in BODIES), strict=True)):
        model = both[0].model
        parameters = {key: value for key, value in asdict(model).items() if key not in {"name", "source"}}
        by_body = dict(zip(BODIES, both, strict=True))
        entry = {
            "name": model.name,
            "parameters": parameters | {"slope": model.slope},
            "source": model.source,
            "relative_life": {body: plain(life.relative_life) for body, life in by_body.items()},
            "million_revolutions": plain(found.million_revolutions(number)),
            "damage": {body: plain(life.damage) for body, life in by_body.items()},
            "reference": {body: plain(life.reference) for body, life in by_body.items()},
        }
        if model.name in found.dent_lives:
            entry["with_dents"] = plain(found.dent_lives[model.name])
        if against is not None:
            entry["ratio"] = {body: plain(against.over(found, body, number)) for body in BODIES}
        models.append(entry)
    spectrum = [
        {
            "load": plain(solution.load),
            "tilt": plain(solution.tilt),
            "share": plain(share),
            # Unbounded at a sharp end, and then None.
            "max_pressure": plain(solution.max_pressure),
        }
        for solution, share in found.spectrum
    ]
    return {
        "title": found.title,
        "status": [solution.status.label for solution, _ in found.spectrum],
        "rollers": found.rollers,
        "raceway": found.raceway,
        "models": models,
        "spectrum": spectrum,
        "verdict": given_verdict(found.verdict),
        "assumed": [each.as_object() for each in found.assumed],
        **as_warnings(found.findings, found.notes),
    }
