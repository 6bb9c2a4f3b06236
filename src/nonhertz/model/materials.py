"""Materials by name, with the sources of their numbers.

Numbers without a source are left out, such as the yield strength of hardened steels, which depends on their heat
treatment. A data sheet of the actual grade takes precedence.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Final

from nonhertz.inputs.checks import text
from nonhertz.inputs.descriptions import Part, unknown_word_error
from nonhertz.model.material import STEEL, STEEL_MODULUS, Material

STEEL_DENSITY = 7.85e-9  # t/mm^3
STEEL_EXPANSION = 12.5e-6  # 1/K, bearing steel (IKO, needle roller bearing catalogue, formula 29)
_LISTED = "nonhertz.MATERIALS lists all"


@dataclass(frozen=True)
class Entry:
    """A material of the library.

    Attributes
    ----------
    name : str
        The name by which a case file refers to it.
    group : str
        Group of materials that it belongs to.
    material : Material
        Its known properties at room temperature.
    source : str
        Source of each number.
    note : str
        Limits of its use; empty if there are none.
    others : tuple of str
        Other names of the material.
    density : float
        [t/mm^3]; for steels by EN 1993-1-2, for others from the same source or from handbooks.
    expansion : float or None
        Linear thermal expansion near room temperature [1/K]; None where sources differ by more than a tenth. Steels
        have that of bearing steel; 440C: AMES Engineering's tables; silicon nitride: between Callister and Lily
        Bearing; aluminium: EN 1999-1-1; others: W. D. Callister, Fundamentals of Materials Science and Engineering,
        table B.6: gray iron, ductile iron 60-40-18 and 80-55-06, bronze C93200.
    """

    name: str
    group: str
    material: Material
    source: str
    note: str = ""
    others: tuple[str, ...] = ()
    density: float = STEEL_DENSITY
    expansion: float | None = STEEL_EXPANSION


_HANDBOOK = "handbook values at room temperature, of no particular grade"
_GEAR_STEEL = "E and nu of steel: ISO 6336-2; hardness, least of a case-hardened surface of quality MQ: ISO 6336-5"
_RAIL = "E and nu: EN 1993-1-1, 3.2.6, of structural steels; hardness, least of the running surface: EN 13674-1"
_CASE = "the yield strength of the case depends on its heat treatment: give your own, and the body its case_depth"
_THROUGH = "the yield strength depends on the heat treatment: give your own"
_UNSTATED = "the standard states no yield strength: give that of your rail"
_FLAKES = (
    "flake graphite: neither linear nor equal in tension and compression; the yield strength is that of 0.1 % proof"
)
_DUCTILE = "EN 1563, separately cast samples: least 0.2 % proof strength; E and nu: its informative annex"
_VISCOELASTIC = (
    "viscoelastic: short-term values at 23 °C; under a lasting load it creeps, at another temperature or rate it is "
    "another material"
)

#: All named materials, by group.
LIBRARY: tuple[Entry, ...] = (
    Entry("steel", "general", STEEL, _HANDBOOK),
    Entry(
        "silicon-nitride", "general", Material(modulus=310000.0, poisson=0.26),
        f"{_HANDBOOK}; within ASTM F2094 for bearing balls, E = 270 to 330 GPa and nu = 0.23 to 0.29",
        density=3.2e-9, expansion=3.2e-6,
    ),
    Entry(
        "cast-iron", "general", Material(modulus=110000.0, poisson=0.26), _HANDBOOK,
        density=7.2e-9, expansion=11.4e-6,
    ),
    Entry("bronze", "general", Material(modulus=110000.0, poisson=0.34), _HANDBOOK, density=8.8e-9, expansion=18e-6),
    Entry("aluminium", "general", Material(modulus=70000.0, poisson=0.33), _HANDBOOK, density=2.7e-9, expansion=23e-6),
    Entry(
        "100Cr6", "bearing and stainless steels",
        Material(modulus=210000.0, poisson=0.3, hardness="58 HRC", pressure_limit=4000.0),
        "ISO 683-17 (grade); E, and hardness from 58 to 65 HRC: SKF, Rolling bearings, materials; nu of steel; largest "
        "pressure in roller bearings: ISO 76",
        _THROUGH, ("52100",),
    ),
    Entry(
        "X105CrMo17", "bearing and stainless steels",
        Material(modulus=200000.0, poisson=0.3, yield_strength=1900.0, hardness="59 HRC"),
        "Atlas Steels, data sheet of grade 440C, tempered at 204 °C; nu of steel",
        "tempered at 371 °C its yield strength is 1660 MPa", ("440C", "1.4125"), expansion=10.1e-6,
    ),
    Entry(
        "16MnCr5", "case-hardening steels",
        Material(modulus=206000.0, poisson=0.3, core_yield_strength=590.0, hardness="58 HRC"),
        f"{_GEAR_STEEL}; core, least of a bar of 30 mm: DIN 17210 (1986)", _CASE,
    ),
    Entry(
        "18CrNiMo7-6", "case-hardening steels",
        Material(modulus=206000.0, poisson=0.3, core_yield_strength=785.0, hardness="58 HRC"),
        f"{_GEAR_STEEL}; core, least of a bar of 30 mm of 17CrNiMo6: DIN 17210 (1986)", _CASE,
    ),
    Entry("R260", "rail steels", Material(modulus=210000.0, poisson=0.3, hardness="260 HBW"), _RAIL, _UNSTATED),
    Entry("R350HT", "rail steels", Material(modulus=210000.0, poisson=0.3, hardness="350 HBW"), _RAIL, _UNSTATED),
    Entry(
        "EN-GJL-250", "cast irons", Material(modulus=110000.0, poisson=0.26, yield_strength=165.0),
        "EN 1561, informative annex: E = 103 to 118 GPa, nu = 0.26, 0.1 % proof strength 165 to 228 MPa", _FLAKES,
        density=7.2e-9, expansion=11.4e-6,
    ),
    Entry(
        "EN-GJS-400-15", "cast irons", Material(169000.0, 0.275, yield_strength=250.0), _DUCTILE,
        density=7.1e-9, expansion=11.2e-6,
    ),
    Entry(
        "EN-GJS-500-7", "cast irons", Material(169000.0, 0.275, yield_strength=320.0), _DUCTILE,
        density=7.1e-9, expansion=None,
    ),
    Entry(
        "EN-GJS-600-3", "cast irons", Material(174000.0, 0.275, yield_strength=370.0), _DUCTILE,
        density=7.2e-9, expansion=10.6e-6,
    ),
    Entry(
        "EN-GJS-700-2", "cast irons", Material(176000.0, 0.275, yield_strength=420.0), _DUCTILE,
        density=7.2e-9, expansion=None,
    ),
    Entry(
        "CuSn11P-C", "copper and aluminium",
        Material(modulus=100000.0, poisson=0.34, yield_strength=130.0, hardness="60 HBW"),
        "EN 1982, cast in sand: 0.2 % proof strength and hardness; E = 90 to 110 GPa: Kemper, data sheet of "
        "CuSn11P-C - GS; nu of bronze",
        others=("CC481K",), density=8.7e-9, expansion=18e-6,
    ),
    Entry(
        "EN-AW-6082-T6", "copper and aluminium", Material(modulus=70000.0, poisson=0.3, yield_strength=250.0),
        "EN 1999-1-1: E and nu, and the 0.2 % proof strength of extrusions up to 5 mm thick",
        density=2.7e-9, expansion=23e-6,
    ),
    Entry(
        "alumina", "ceramics", Material(modulus=416000.0, poisson=0.231),
        "R. G. Munro, Evaluated material properties for a sintered alpha-alumina, Journal of the American Ceramic "
        "Society 80 (1997) 1919",
        "brittle: it cracks instead of yielding; of at least 99.5 % purity and 98 % density",
        density=3.98e-9, expansion=None,
    ),
    Entry(
        "zirconia", "ceramics", Material(modulus=210000.0, poisson=0.3, hardness="1200 HV"),
        "E and hardness of Y-TZP: C. Piconi, G. Maccauro, Zirconia as a ceramic biomaterial, Biomaterials 20 (1999) 1; "
        "nu: manufacturers' data sheets",
        "brittle: it cracks instead of yielding", density=6.05e-9, expansion=None,
    ),
    Entry(
        "POM", "polymers", Material(modulus=3100.0, poisson=0.35, yield_strength=70.0),
        "DuPont, Delrin 500P: data sheet by ISO 527; nu: Delrin design guide", _VISCOELASTIC,
        density=1.42e-9, expansion=None,
    ),
    Entry(
        "PA66", "polymers", Material(modulus=1400.0, poisson=0.41, yield_strength=55.0),
        "DuPont, Zytel 103HSL, conditioned: data sheet by ISO 527; nu: Zytel design guide",
        f"{_VISCOELASTIC}; dry as moulded its E is 3100 MPa and its yield strength 85 MPa",
        density=1.14e-9, expansion=None,
    ),
    Entry(
        "PEEK", "polymers", Material(modulus=4000.0, poisson=0.4, yield_strength=98.0),
        "Victrex, PEEK 450G: data sheet by ISO 527; nu: Victrex properties guide", _VISCOELASTIC,
        density=1.3e-9, expansion=None,
    ),
)  # fmt: skip


class _Materials(dict[str, Material]):
    """Materials by name; the error for an unknown name suggests the nearest."""

    def __missing__(self, name: object) -> Material:
        raise KeyError(str(unknown_word_error("name", name, "material", self, _LISTED)))

    def __repr__(self) -> str:
        return "\n".join(f"{name}: {material!r}" for name, material in self.items())


#: Materials that a case file may refer to by name.
MATERIALS = _Materials(
    {entry.name: entry.material for entry in LIBRARY}
    | {other: entry.material for entry in LIBRARY for other in entry.others}
)

#: What the material of a part may be: one of these by its name, or any other.
NAMED: Final = Part(
    "name of a material, or a table of modulus, poisson and strengths",
    Material,
    "give modulus and poisson, or a name such as 'steel' or '100Cr6'",
    MATERIALS,
)
NamedMaterial = Annotated[Material, NAMED]


def find_entry(name: str) -> Entry:
    """Return the entry of the library with this name.

    Raises
    ------
    InputError
        If the name is unknown.
    """
    text("name", name, "give a name such as 'steel' or '100Cr6'")
    for entry in LIBRARY:
        if name in (entry.name, *entry.others):
            return entry
    raise unknown_word_error("name", name, "material", MATERIALS, _LISTED)


def name_of(material: Material) -> str:
    """Return the first name of a material in the library; empty if it is not there."""
    return next((entry.name for entry in LIBRARY if entry.material == material), "")


def density_of(material: Material) -> float | None:
    """Return the density [t/mm^3] of a material of the library or one as stiff as steel; None for any other."""
    entry = _entry_of(material)
    return entry.density if entry else STEEL_DENSITY if _as_stiff_as_steel(material) else None


def expansion_of(material: Material) -> float | None:
    """Return the linear thermal expansion [1/K] likewise; None for any other, or where it is not known."""
    entry = _entry_of(material)
    return entry.expansion if entry else STEEL_EXPANSION if _as_stiff_as_steel(material) else None


def _entry_of(material: Material) -> Entry | None:
    """Return the entry of the library, or one that has the same stiffness and hardness."""

    def known(of: Material) -> tuple[object, ...]:
        return of.modulus, of.poisson, of.hardness

    alike = [entry for entry in LIBRARY if known(entry.material) == known(material)]
    return next((entry for entry in alike if entry.material == material), alike[0] if alike else None)


def _as_stiff_as_steel(material: Material) -> bool:
    low, high = STEEL_MODULUS
    return low <= material.modulus <= high
