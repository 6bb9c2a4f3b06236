"""Solutions that are saved and read again: the same to the last bit, or refused in one sentence."""

import dataclasses

import numpy as np
import pytest

import nonhertz as nh

pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.AccuracyWarning")

ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000))
CROWNED = nh.Contact(ROLLER, nh.Plate())
STRAIGHT = nh.Contact(nh.Roller(diameter=20, length=20, depth="none"), nh.Ring(diameter=80))
LAYERED = nh.Contact(nh.Roller(diameter=20, length=20, images="series"), nh.Plate(length=30, depth=15))
BALL = nh.Contact(nh.Body(diameter=20, profile=nh.profile.crown(radius=10)), nh.Plate())
COLUMNS = (
    "approach", "tilt", "load", "moment", "max_pressure", "max_pressure_y", "max_half_width", "contact_length",
    "penetration", "stiffness", "singular", "converged",
)  # fmt: skip


class UnluckyError(Exception):
    """What only the profile below raises."""


class Moody(nh.profile.Profile):
    """A profile of the user's own, which fails."""

    def __init__(self, error: Exception) -> None:
        self.error = error

    def relief(self, y):
        raise self.error


def moody(error: Exception) -> nh.Contact:
    return nh.Contact(nh.Roller(diameter=20, length=20, profile=Moody(error)), nh.Plate())


def again(many: nh.Solutions, contacts, tmp_path) -> nh.Solutions:
    many.save(tmp_path / "many.npz")
    return nh.Solutions.read(tmp_path / "many.npz", contacts)


def assert_same_solution(found: nh.Solution, expected: nh.Solution) -> None:
    for name in names_of(nh.Solution):
        ours, theirs = getattr(found, name), getattr(expected, name)
        if isinstance(theirs, np.ndarray):
            np.testing.assert_array_equal(ours, theirs, err_msg=name)
        else:
            assert ours == theirs, name


def names_of(kind: type[nh.Solution]) -> set[str]:
    """Fields of a solution, and what its judgement says of it."""
    judged = {"contact_y", "edge_pressure", "singular_ends", "peaks_at_corner", "error_estimate", "findings"}
    return judged | {each.name for each in dataclasses.fields(kind)} - {"judgement"}


def assert_same(found: nh.Solutions, expected: nh.Solutions) -> None:
    assert found.shape == expected.shape
    for name in COLUMNS:
        np.testing.assert_array_equal(getattr(found, name), getattr(expected, name), err_msg=name)
    assert list(found.failures) == list(expected.failures)
    for ours, theirs in zip(found.failures.values(), expected.failures.values(), strict=True):
        assert (type(ours), str(ours)) == (type(theirs), str(theirs))
    assert found.warnings == expected.warnings
    for number in np.ndindex(expected.shape):
        if expected.converged[number]:
            assert_same_solution(found[number], expected[number])
    assert found.to_dataframe().equals(expected.to_dataframe())


@pytest.mark.parametrize(
    ("contacts", "case"),
    [
        (CROWNED, {"load": np.linspace(2e3, 9e3, 70), "tilt": 2e-4, "strips": 15}),
        (CROWNED, {"load": [[2e3], [9e3]], "moment": [0.0, 2e3, 4e3]}),
        (CROWNED, {"load": [2e3, 3e3], "strips": 12, "element": nh.PARABOLIC}),
        (CROWNED, {"load": 2e3, "accuracy": 1e-3}),
        (CROWNED, {"load": 2e3, "accuracy": 1e-4, "accuracy_of": "pressure"}),
        ([CROWNED, STRAIGHT, LAYERED, CROWNED], {"load": [[5e3], [8e3]], "strips": 15}),
        ([CROWNED, STRAIGHT, BALL], {"load": [5e3, 8e3, 800.0]}),
        (BALL, {"load": [500.0, 900.0], "strips": 30}),
        (CROWNED, {"load": [2e3, 4e6], "strips": [-8.0, -2.0, 1.0, 8.0]}),
        (CROWNED, {"approach": [0.01, -0.5, 0.012], "strips": 15}),
    ],
    ids=["equal", "automatic", "parabolic", "accuracy", "pressure", "contacts", "grids", "ball", "edges", "failure"],
)
def test_saved_solutions_are_the_same_to_the_last_bit(contacts, case, tmp_path):
    many = nh.solve_many(contacts, **case)
    found = again(many, contacts, tmp_path)
    assert_same(found, many)
    np.testing.assert_array_equal(found.column("load_by_approach"), many.column("load_by_approach"))
    assert_same(again(found, contacts, tmp_path), many)


@pytest.mark.parametrize(
    "error",
    [
        ValueError("out of paper"), KeyError("length"), OSError(2, "no such profile"), UnluckyError("not today", 3),
        nh.InputError("profile", float("nan"), "be finite", "mend it"),
        nh.InputError("profile", ROLLER, "be simple", "mend it"),
        nh.InputError("profile", np.float64(2.5), "be simple", "mend it"),
    ],
    ids=["value", "key", "system", "own", "nan", "object", "numpy"],
)  # fmt: skip
def test_errors_come_back_with_type_and_message(error, tmp_path):
    contacts = [CROWNED, moody(error)]
    many = nh.solve_many(contacts, load=5e3, strips=11)
    assert type(many.failures[1]) is type(error)
    found = again(many, contacts, tmp_path)
    assert (type(found.failures[1]), str(found.failures[1])) == (type(error), str(error))
    with pytest.raises(type(error)):
        found[1]


def test_an_error_of_an_unknown_type_comes_back_with_its_name_and_message(tmp_path):
    class FleetingError(Exception):
        def __init__(self) -> None:
            super().__init__("takes no arguments")

    many = nh.solve_many(moody(FleetingError()), load=5e3, strips=11)
    found = again(many, moody(FleetingError()), tmp_path)
    assert type(found.failures[0]) is nh.NonhertzError
    assert str(found.failures[0]) == "FleetingError: takes no arguments"


def test_the_state_that_a_refuted_case_reached_comes_back(tmp_path):
    # Tilt times y is 0.1 mm and rounded to 1e-17, the interference 2e-14.
    contact = nh.Contact(nh.Roller(diameter=20, length=20, side_faces="none", depth="none"), nh.Plate(depth="none"))
    edges = np.linspace(9.999999, 10.0, 12)
    given = {"approach": [2e-14 - 1e-2 * np.mean(edges[-2:])] * 2, "tilt": 1e-2, "strips": edges}
    many = nh.solve_many(contact, **given)
    assert [type(error) for error in many.failures.values()] == [nh.ConvergenceError] * 2
    found = again(many, contact, tmp_path)
    assert str(found.failures[1]) == str(many.failures[1])
    assert_same_solution(found.failures[1].solution, many.failures[1].solution)


def test_cases_that_a_stopped_run_left_are_saved_too(tmp_path):
    def stop(portion):
        raise KeyboardInterrupt

    with pytest.raises(nh.Interrupted) as stopped:
        nh.solve_many(CROWNED, load=np.linspace(2e3, 9e3, 2000), strips=15, callback=stop)
    many = stopped.value.solutions
    found = again(many, CROWNED, tmp_path)
    assert not found.converged.all()
    np.testing.assert_array_equal(found.load, many.load)
    assert {number: str(error) for number, error in found.failures.items()} == {
        number: str(error) for number, error in many.failures.items()
    }


MANY = {"load": [[5e3], [8e3]], "strips": 11}


@pytest.mark.parametrize(
    ("contacts", "complaint"),
    [
        ([STRAIGHT, CROWNED], r"^contacts\[0\] = .* must be the contact that the cases were solved with"),
        ([CROWNED, nh.Contact(STRAIGHT.b, STRAIGHT.a)], r"^contacts\[1\] = "),
        ([CROWNED, nh.Contact(STRAIGHT.a, nh.Ring(diameter=80.0001))], r"^contacts\[1\] = "),
        ([CROWNED, nh.Contact(dataclasses.replace(STRAIGHT.a, depth=50.0), STRAIGHT.b)], r"^contacts\[1\] = "),
        ([CROWNED, nh.Contact(dataclasses.replace(STRAIGHT.a, side_faces="none"), STRAIGHT.b)], r"^contacts\[1\] = "),
        (CROWNED, "^contacts = .* must be the contact that the cases were solved with"),
        ([CROWNED, STRAIGHT, CROWNED], "^number of contacts = 3 must be 1 or 2"),
        ([CROWNED, None], r"^contacts\[1\] = None must be a Contact"),
    ],
    ids=["swapped", "bodies", "diameter", "depth", "faces", "one", "three", "none"],
)
def test_other_contacts_are_refused(contacts, complaint, tmp_path):
    nh.solve_many([CROWNED, STRAIGHT], **MANY).save(tmp_path / "many.npz")
    with pytest.raises(nh.InputError, match=complaint) as refused:
        nh.Solutions.read(tmp_path / "many.npz", contacts)
    assert "\n" not in str(refused.value)


def test_equal_contacts_that_were_made_again_are_taken(tmp_path):
    many = nh.solve_many([CROWNED, CROWNED, STRAIGHT], **MANY)
    fresh = [
        nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(4000)), nh.Plate()) for _ in range(2)
    ]
    found = again(many, [*fresh, nh.Contact(STRAIGHT.a, STRAIGHT.b)], tmp_path)
    np.testing.assert_array_equal(found.max_pressure, many.max_pressure)


def test_files_that_hold_no_whole_solutions_are_refused_in_one_sentence(tmp_path):
    nh.solve_many(CROWNED, load=[2e3, 3e3], strips=11).save(tmp_path / "many.npz")
    with np.load(tmp_path / "many.npz", allow_pickle=False) as archive:
        entries = dict(archive)
    damaged = [
        ("hold solutions of nonhertz", {**entries, "kind": np.asarray("nonhertz map")}),
        ("hold solutions of version 2", {**entries, "version": np.asarray(1)}),
    ]
    for name in entries.keys() - {"kind", "version"}:
        damaged.append(("hold undamaged solutions", {key: value for key, value in entries.items() if key != name}))
        if entries[name].size > 1:
            damaged.append(("hold undamaged solutions", {**entries, name: entries[name][:-1]}))
            damaged.append(("hold undamaged solutions", {**entries, name: entries[name] + 1}))
    for condition, content in damaged:
        np.savez(tmp_path / "other.npz", **content)
        with pytest.raises(nh.InputError, match=condition) as refused:
            nh.Solutions.read(tmp_path / "other.npz", CROWNED)
        assert "\n" not in str(refused.value)
    whole = (tmp_path / "many.npz").read_bytes()
    for name, data in (("text", b"approach,load\n"), ("cut", whole[: len(whole) // 2]), ("none", b"")):
        (tmp_path / name).write_bytes(data)
        with pytest.raises(nh.InputError, match="must hold solutions of nonhertz"):
            nh.Solutions.read(tmp_path / name, CROWNED)
    with pytest.raises(nh.InputError, match="must be a file that can be read"):
        nh.Solutions.read(tmp_path / "nowhere.npz", CROWNED)


def test_an_old_file_survives_a_failed_save(tmp_path, monkeypatch):
    path = tmp_path / "many.npz"
    many = nh.solve_many(CROWNED, load=[2e3, 3e3], strips=11)
    many.save(path)

    def full(file, **arrays):
        file.write(b"PK")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(np, "savez", full)
    with pytest.raises(OSError, match="No space left"):
        many.save(path)
    assert [each.name for each in tmp_path.iterdir()] == ["many.npz"]
    np.testing.assert_array_equal(nh.Solutions.read(path, CROWNED).load, many.load)


@pytest.mark.slow
def test_an_element_of_ones_own_is_not_saved(tmp_path):
    own = dataclasses.replace(nh.PARABOLIC, name="own")
    many = nh.solve_many(CROWNED, load=[2e3], strips=11, element=own)
    with pytest.raises(nh.InputError, match=r"^element = 'own' must be one of nonhertz"):
        many.save(tmp_path / "many.npz")
