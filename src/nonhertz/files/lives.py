"""The lives of both bodies of a case, as text and as files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from operator import attrgetter, itemgetter
from types import SimpleNamespace
from typing import Any, Final

from nonhertz.files import results
from nonhertz.files.results import Key, ListOf, key_by_key, plain, within
from nonhertz.findings import Finding, sentences
from nonhertz.life import Life, Overrolled, VolumeModel
from nonhertz.model.body import BODIES, BodyName
from nonhertz.result.solution import Solution
from nonhertz.result.tables import csv_text
from nonhertz.verdict import Verdict, add_life, judge_loads

_COLUMNS = ("body", "model", "y [mm]", "density")


@dataclass(frozen=True, eq=False)
class Assessment:
    """The lives of both bodies of a case.

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
        The number of dents: keywords of `Overrolled.relative_life`.
    required : float or None
        The required life [10^6 revolutions].
    assumed : tuple of Finding
        The assumptions of the models for inputs that the case leaves out.
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
        """The ratio of the life of the raceway with dents to that without, by every volume model."""
        if self.dent is None:
            return {}
        return {model.name: self.dent.relative_life(model, **self.dents) for model in self._volume_models}

    @property
    def judging_dents(self) -> VolumeModel:
        """The first volume model other than of orthogonal shear, which dents hardly change."""
        return min(self._volume_models, key=lambda model: model.stress == "orthogonal_shear")

    @property
    def _volume_models(self) -> list[VolumeModel]:
        return [life.model for life in self.lives["b"] if isinstance(life.model, VolumeModel)]

    @property
    def raceway(self) -> BodyName | None:
        """The body on which a roller rolls, whose life is given in revolutions; None if there is none."""
        ring = self.lives["b"][0].raceway
        return None if ring is None else ring.body

    @property
    def verdict(self) -> Verdict | None:
        """Whether limits are met under all loads, and the required life by every model; the worst verdict of all."""
        lives = [self.million_revolutions(number) for number in range(len(self.lives["b"]))]
        return add_life(judge_loads(self.spectrum), min(filter(None, lives), default=None), self.required)

    @property
    def warnings(self) -> tuple[str, ...]:
        """The notes and all findings, a sentence each."""
        return tuple(dict.fromkeys((*self.notes, *sentences(self.findings))))

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings on the lives and on a dent, each once."""
        findings = [] if self.dent is None else [*self.dent.findings]
        for life in (life for body in BODIES for life in self.lives[body]):
            findings += life.findings
        return tuple(dict.fromkeys(findings))

    def million_revolutions(self, number: int) -> float | None:
        """Return the life of the raceway by one of the models [10^6 revolutions], or None."""
        return self.lives[self.raceway or "b"][number].million_revolutions

    def over(self, other: Assessment, body: BodyName, number: int) -> float:
        """Return the ratio of a body's life by one of the models to that in another case [-]."""
        return self.lives[body][number].over(other.lives[body][number])


def _models(case: Any) -> list[SimpleNamespace]:
    """Return the lives of both bodies by each model."""
    assessment, first, models = case.lives, case.first, []
    for number, lives in enumerate(zip(*(assessment.lives[body] for body in BODIES), strict=True)):
        by_model = SimpleNamespace(**dict(zip(BODIES, lives, strict=True)), model=lives[0].model)
        by_model.million_revolutions = assessment.million_revolutions(number)
        by_model.with_dents = assessment.dent_lives.get(by_model.model.name)
        by_model.ratio = first and SimpleNamespace(**{body: first.over(assessment, body, number) for body in BODIES})
        models.append(by_model)
    return models


def _parameters(by_model: Any) -> dict[str, Any]:
    fields = {name: value for name, value in asdict(by_model.model).items() if name not in {"name", "source"}}
    return fields | {"slope": by_model.model.slope}


def _of_bodies(name: str, meaning: str, unit: str | None = None) -> Key:
    keys = tuple(Key(body, f"of body {body}", get=f"{body}.{name}") for body in BODIES)
    return Key(name, meaning, unit, lambda by_model: by_model, keys)


_MODEL: Final = (
    Key("name", "the model", get="model.name", holds="string"),
    Key("parameters", "its parameters, and Weibull's slope", {"fatigue_limit": "MPa"}, _parameters, "object"),
    Key("source", "reference", get="model.source", holds="string"),
    _of_bodies("relative_life", "life relative to that under the ideal pressure; null without damage or such a life"),
    Key("million_revolutions", "L10 of the raceway; null if there is none", "10^6 revolutions"),
    _of_bodies("damage", "0 is an infinite life", "MPa^exponent mm^(2 - depth_exponent), of iso-16281 none"),
    _of_bodies("reference", "damage under the ideal pressure", "as damage"),
    Key(
        "with_dents", "ratio of the life of the raceway with dents to that without; left out without a dent",
        applies=lambda by_model: by_model.with_dents is not None,
    ),
    Key(
        "ratio", "lives of the first case over these; only in compared_with", applies=lambda by_model: by_model.ratio,
        holds=tuple(Key(body, f"of body {body}") for body in BODIES),
    ),
)  # fmt: skip
_LOAD: Final = (
    *within(itemgetter(0), Key("load", "load", "N"), Key("tilt", "tilt", "rad")),
    Key("share", "share of the revolutions", get=itemgetter(1)),
    *within(itemgetter(0), Key("max_pressure", "maximum pressure; null where it is unbounded", "MPa")),
)
_CASE: Final = (
    *within(
        "lives",
        Key("title", "title of the case", holds="string"),
        Key(
            "status", "how the solve for each load ended", holds=ListOf("string"),
            get=lambda lives: [solution.status.label for solution, _ in lives.spectrum],
        ),
        Key("rollers", "number of rollers in the bearing", holds="integer", nullable=True),
        Key("raceway", "body on which a roller rolls, a or b", holds="string", nullable=True),
    ),
    Key("models", "lives by each model", get=_models, holds=ListOf(_MODEL)),
    *within(
        "lives",
        Key("spectrum", "the loads", holds=ListOf(_LOAD)),
        results.verdict_key(attrgetter("verdict")),
        results.assumed_key("assumed"),
        *results.warning_keys(attrgetter("findings"), attrgetter("notes")),
    ),
)  # fmt: skip
#: Keys of the file of lives.
LIVES: Final = (
    *_CASE,
    Key(
        "compared_with", "the same for the case of the comparison; left out without one", "", holds=_CASE,
        get=lambda case: SimpleNamespace(lives=case.other, first=case.lives), applies=lambda case: case.other,
    ),
    results.UNITS,
)  # fmt: skip


def as_object(lives: Assessment, other: Assessment | None = None) -> dict[str, Any]:
    """Return lives, and those of a case for comparison, as plain numbers, text, lists and dictionaries."""
    return results.document(LIVES, lives=lives, other=other, first=None)


def as_table(lives: Assessment) -> str:
    """Return the damage density along both bodies as CSV with a header of names and units."""
    rows = (
        [body, life.model.name, y, plain(density)]
        for body in BODIES
        for life in lives.lives[body]
        for y, density in zip(life.y.tolist(), life.density.tolist(), strict=True)
    )
    return csv_text(_COLUMNS, rows)


def files(lives: Assessment, other: Assessment | None) -> dict[str, str]:
    """Return the texts of life.json and life.csv, and of compared.csv if there is another case, by file name."""
    texts = {"life.json": key_by_key(as_object(lives, other)) + "\n", "life.csv": as_table(lives)}
    return texts if other is None else texts | {"compared.csv": as_table(other)}
