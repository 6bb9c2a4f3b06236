"""Elastic constants and what follows from them."""

import pytest

import nonhertz as nh
from nonhertz.files.writing import document_of
from nonhertz.model.materials import LIBRARY, expansion_of, find_entry


def test_compliance_and_shear_modulus_of_steel():
    # (1 - 0.09) / (pi 207000) and 207000 / 2.6, worked out by hand.
    steel = nh.Material(modulus=207000, poisson=0.3)
    assert abs(steel.compliance - 1.399333e-6) < 1e-12
    assert abs(steel.shear_modulus - 79615.38) < 0.01


def test_what_a_material_bears_is_left_out_where_it_is_not_known():
    plain = nh.Material(207000, 0.3)
    known = nh.Material(207000, 0.3, yield_strength=1800, hardness="60HRC", pressure_limit=4000)
    assert plain == nh.MATERIALS["steel"]
    assert hash(plain) == hash(nh.MATERIALS["steel"])
    assert repr(plain) == "Material(modulus=207000, poisson=0.3)"
    assert plain != known
    assert known.hardness == "60 HRC"
    assert plain.shear_yield_strength is None
    # Pure shear k: von Mises stress sqrt(3) k.
    assert abs(known.shear_yield_strength - 1039.23048) < 1e-5


@pytest.mark.parametrize(
    ("given", "complaint"),
    [
        ({"poisson": 0.51}, "poisson = 0.51 must lie in (-1, 0.5]"),
        ({"poisson": -1.0}, "poisson = -1.0 must lie in (-1, 0.5]"),
        ({"pressure_limit": "4000"}, "pressure_limit = '4000' must have a unit: write 4000 without quotes"),
        ({"hardness": 60}, "hardness = 60 must be a number with its scale, HV, HRC or HBW"),
        ({"hardness": "60 Shore D"}, "hardness = '60 Shore D' must be a number with its scale"),
        ({"hardness": "75 HRC"}, "hardness = '75 HRC' must lie between 20 and 70 HRC"),
    ],
)
def test_impossible_constants_and_strengths_are_refused(given, complaint):
    with pytest.raises(nh.InputError) as refusal:
        nh.Material(**{"modulus": 207000, "poisson": 0.3} | given)
    assert str(refusal.value).startswith(complaint)


@pytest.mark.parametrize(("modulus", "poisson"), [(207, 0.3), (700, 0.22)])
def test_a_modulus_in_gpa_is_doubted(modulus, poisson):
    with pytest.warns(nh.AccuracyWarning, match=f"A modulus of {modulus} MPa .* give the modulus in MPa") as warned:
        nh.Material(modulus, poisson)
    assert warned[0].filename == __file__


# Rubber, low-density polyethylene, PTFE and polyamide: soft, but nothing to doubt.
@pytest.mark.parametrize(("modulus", "poisson"), [(1.5, 0.499), (200, 0.45), (500, 0.46), (1500, 0.39)])
def test_soft_materials_are_what_they_are(modulus, poisson):
    assert nh.Material(modulus, poisson).modulus == modulus


def test_every_material_of_the_library_has_a_source_and_numbers_of_its_own():
    assert all(each.source for each in LIBRARY)
    names = [name for each in LIBRARY for name in (each.name, *each.others)]
    assert len(set(names)) == len(names)
    assert set(names) == set(nh.MATERIALS)
    # A case file that is written back names the first that is equal.
    assert len({each.material for each in LIBRARY}) == len(LIBRARY)
    for each in LIBRARY:
        assert document_of(each.material) == each.name
        assert nh.Roller(diameter=10, length=10, material=each.name).material == each.material


def test_other_names_stand_for_the_same():
    assert nh.MATERIALS["52100"] is nh.MATERIALS["100Cr6"]
    assert find_entry("440C").name == "X105CrMo17"


@pytest.mark.parametrize(
    ("name", "nearest"), [("100cr6", "100Cr6"), ("stele", "steel"), ("EN-GJS-400", "EN-GJS-400-15")]
)
def test_a_name_that_is_none_names_the_nearest(name, nearest):
    with pytest.raises(KeyError, match=f"must be a known material: did you mean '{nearest}'"):
        nh.MATERIALS[name]
    with pytest.raises(nh.InputError, match=f"must be a known material: did you mean '{nearest}'"):
        nh.Roller(diameter=10, length=10, material=name)


# Handbook ranges at room temperature [GPa]: wide enough for grades, too narrow for a slip of a digit.
@pytest.mark.parametrize(
    ("name", "low", "high"),
    [
        ("steel", 200, 212),
        ("silicon-nitride", 290, 330),
        ("cast-iron", 90, 170),
        ("bronze", 95, 125),
        ("aluminium", 68, 75),
        ("100Cr6", 200, 215),
        ("X105CrMo17", 195, 220),
        ("16MnCr5", 200, 215),
        ("18CrNiMo7-6", 200, 215),
        ("R260", 200, 215),
        ("R350HT", 200, 215),
        ("EN-GJL-250", 103, 118),
        ("EN-GJS-600-3", 160, 180),
        ("CuSn11P-C", 90, 110),
        ("EN-AW-6082-T6", 68, 72),
        ("zirconia", 200, 220),
        ("alumina", 350, 420),
        ("PA66", 1.2, 2.0),
        ("PEEK", 3.6, 4.2),
    ],
)
def test_named_materials_have_handbook_moduli(name, low, high):
    assert low <= nh.MATERIALS[name].modulus / 1000.0 <= high
    assert 0.2 < nh.MATERIALS[name].poisson < (0.36 if low > 60 else 0.43)


# Of strengths alike [MPa]: hardened steel, grey and ductile iron by their grades, and ISO 76 for line contact.
@pytest.mark.parametrize(
    ("name", "quantity", "low", "high"),
    [
        ("100Cr6", "pressure_limit", 4000, 4000),
        ("X105CrMo17", "yield_strength", 1650, 1950),
        ("16MnCr5", "core_yield_strength", 550, 750),
        ("18CrNiMo7-6", "core_yield_strength", 700, 900),
        ("EN-GJS-400-15", "yield_strength", 240, 260),
        ("EN-GJS-700-2", "yield_strength", 400, 440),
        ("CuSn11P-C", "yield_strength", 120, 150),
        ("PA66", "yield_strength", 45, 65),
        ("PEEK", "yield_strength", 90, 105),
    ],
)
def test_named_materials_have_handbook_strengths(name, quantity, low, high):
    assert low <= getattr(nh.MATERIALS[name], quantity) <= high


def test_expansions_are_those_of_the_material_or_of_none():
    """W. D. Callister, Fundamentals of Materials Science and Engineering, table B.6, and EN 1999-1-1."""
    of = {each.name: expansion_of(each.material) for each in LIBRARY}
    assert of["bronze"] == of["CuSn11P-C"] == 18e-6
    assert (of["aluminium"], of["EN-GJL-250"], of["EN-GJS-600-3"]) == (23e-6, 11.4e-6, 10.6e-6)
    assert of["100Cr6"] == of["steel"] == expansion_of(nh.Material(205e3, 0.29)) == 12.5e-6
    assert 3.1e-6 < of["silicon-nitride"] < 3.3e-6
    assert of["EN-GJS-500-7"] is of["PEEK"] is expansion_of(nh.Material(72e3, 0.3)) is None
