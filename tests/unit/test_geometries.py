"""Bearing files from designations, and tables of geometries of one's own."""

import tomllib

import pytest

import nonhertz as nh
from nonhertz.files.geometries import bearing_of_designation, published_geometries

# Read in the catalogues by hand: d, D, B, C, C_0, F and E.
BY_HAND = {
    "206": (30, 62, 16, 44e3, 36.5e3, 37.5, 55.5),
    "305": (25, 62, 17, 46.5e3, 36.5e3, 34.0, 54.0),
    "2211": (55, 100, 25, 114e3, 118e3, 66.0, 90.0),
    "2320": (100, 215, 73, 670e3, 735e3, 127.5, 191.5),
    "1010": (50, 80, 16, 32e3, 36e3, 57.5, 72.5),
    "412": (60, 150, 35, 167e3, 168e3, 83.0, 127.0),
}
HEAD = "designation,kind,d,D,B,C,C0,F,E,Z,L,e,source\n"


@pytest.mark.parametrize("size", BY_HAND)
def test_rows_are_those_of_the_catalogues(size):
    row = published_geometries()[size]
    assert tuple(float(row[symbol]) for symbol in ("d", "D", "B", "C", "C0", "F", "E")) == BY_HAND[size]


def test_sizes_of_a_series_grow_and_rollers_fit_in_every_row():
    rows = published_geometries()
    assert len(rows) == 146
    for size, row in rows.items():
        d, outside, width, dynamic, static, inner, outer = (
            float(row[symbol]) for symbol in ("d", "D", "B", "C", "C0", "F", "E")
        )
        assert d == {"03": 17.0}.get(size[-2:], 5.0 * int(size[-2:]))  # codes of bores, ISO 15
        assert d < inner < outer < outside
        assert 0.4 < (outer - inner) / (outside - d) < 0.6
        assert width < outside - d
        assert 0.6 < dynamic / static < 1.5
        assert row["source"]
    for size, row in rows.items():
        if "2" + size in rows and size[:-2] in ("2", "3"):  # 22 and 23 have the raceways of 2 and 3
            assert (rows["2" + size]["F"], rows["2" + size]["E"]) == (row["F"], row["E"])


@pytest.mark.parametrize(("designation", "design"), [("NU 206", "NU"), ("nj206-E-TVP2", "NJ"), ("N 206 ECP", "N")])
def test_a_designation_starts_a_file_that_is_solved(designation, design, tmp_path):
    text = bearing_of_designation(designation)
    bearing = tomllib.loads(text)["bearing"]
    assert bearing["design"] == design
    assert (bearing["series"], bearing["bore"], bearing["outside_diameter"], bearing["width"]) == ("2", 30, 62, 16)
    assert "SKF General Catalogue" in text.partition("\n\n")[0]
    path = tmp_path / "nu206.toml"
    path.write_text(text, encoding="utf-8")
    case = nh.read_bearing(path, {"solver.method": "slices"})
    row = case.bearing.rows[0].bearing
    assert (row.inner.diameter, row.outer.diameter, row.roller_diameter, row.rollers) == (37.5, -55.5, 9.0, 13)
    assert case.solve().load.max() > 0.0


def test_rows_of_ones_own_have_precedence_and_may_be_of_any_kind(tmp_path):
    own = tmp_path / "own.csv"
    rows = [
        "# measured",
        "NU 206,,30,62,16,40kN,36000,38,55,12,8.5,,drawing 7",
        "30306 J,tapered,30,72,20.75,59.5kN,60kN,,,14,,0.31,measured",
    ]
    own.write_text(HEAD + "\n".join(rows), encoding="utf-8")
    document = tomllib.loads(bearing_of_designation("nu206", own))
    assert (document["bearing"]["rollers"], document["roller"]["length"], document["inner"]["diameter"]) == (
        12,
        8.5,
        38,
    )
    assert "design" not in document["bearing"]
    tapered = bearing_of_designation("30306J", own)
    assert tomllib.loads(tapered)["bearing"]["rollers"] == 14
    assert "the number of rollers was given" in tapered
    assert "geometry: measured" in tapered
    assert tomllib.loads(bearing_of_designation("NU 207", own))["inner"]["diameter"] == 44.0


@pytest.mark.parametrize(
    ("designation", "table", "sentence"),
    [
        (
            "NU 2232",
            None,
            "such as NU 2230, NU 2228 or NU 2226: give its catalogue data, or geometries with a row of it",
        ),
        ("N", None, "'N' must be a known cylindrical roller bearing, such as NU 206"),
        ("NU 12345", None, "must be a known cylindrical roller bearing"),
        ("NU 206", "", "geometries = 'own.csv' must be a comma-separated table of designation, kind, d"),
        ("NU 206", "a,b\n1,2\n", "must be a comma-separated table"),
        ("NU 206", HEAD + "NU 206,,30\n", "must have as many values in each row as in its header"),
        ("X 1", HEAD + "X1,,30,62,16,44kN,ten,,,,,,me\n", "C0 = 'ten' must"),
        ("X 1", HEAD + "X1,,30,62,16,44kN,36kN,,,70,,,me\n", "C0 = 36000.0 must be that of rollers which fit"),
        ("X1-", HEAD + "X12,,30,62,16,44kN,36kN,,,,,,me\n", "such as X12, NU 206"),
    ],
)
def test_what_is_in_no_table_is_refused(designation, table, sentence, tmp_path):
    own = None if table is None else tmp_path / "own.csv"
    if own is not None:
        own.write_text(table, encoding="utf-8")
    with pytest.raises(nh.InputError) as raised:
        bearing_of_designation(designation, own)
    assert sentence in str(raised.value)
