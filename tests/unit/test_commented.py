"""A changed document in the text of its file: what was changed is new, all else is as it was."""

import copy
import tomllib

import pytest

from nonhertz.files.commented import update_toml
from nonhertz.files.starting import BEARING_TEMPLATES, TEMPLATES, starting_bearing, starting_case
from nonhertz.files.toml import to_toml

TEXTS = [starting_case(name) for name in (None, *TEMPLATES)]
TEXTS += [starting_bearing(name) for name in (None, *BEARING_TEMPLATES)]


def comments(text):
    return [line.partition("#")[2] for line in text.splitlines() if "#" in line]


@pytest.mark.parametrize("text", TEXTS)
def test_a_document_that_is_the_same_leaves_the_text_as_it_was(text):
    assert update_toml(tomllib.loads(text), text) == text


@pytest.mark.parametrize("text", TEXTS)
def test_a_changed_value_changes_one_line(text):
    document = tomllib.loads(text)
    document["title"] = "another"
    (changed,) = set(update_toml(document, text).splitlines()) - set(text.splitlines())
    assert changed.startswith('title = "another"')


CHANGES = {
    "a value": lambda document: document["load"].update(load="25 kN"),
    "a key more": lambda document: document["body"]["a"].update(chamfer={"length": 1.0, "angle": 0.2}),
    "a key less": lambda document: document["body"]["a"].pop("side_faces"),
    "a table more": lambda document: document.update(life={"rollers": 3, "spectrum": [{"load": 1.0, "share": 1.0}]}),
    "a table less": lambda document: document.pop("solver"),
    "a word for a table": lambda document: document["body"]["b"].update(material="100Cr6"),
    "a table for a word": lambda document: document["body"]["a"].update(material={"modulus": 1e5, "poisson": 0.3}),
    "a profile more": lambda document: document["body"]["a"]["profile"].append({"kind": "crown", "radius": 4e3}),
    "another profile": lambda document: document["body"]["a"].update(profile=[{"kind": "crown", "drop": "5 um"}]),
    "no profile": lambda document: document["body"]["a"].update(profile=[]),
    "true for one": lambda document: document["solver"].update(strips=True),
}


@pytest.mark.parametrize("change", CHANGES)
def test_any_change_is_in_the_text_and_comments_stay(change):
    text = starting_case()
    document = copy.deepcopy(tomllib.loads(text))
    CHANGES[change](document)
    found = update_toml(document, text)
    assert tomllib.loads(found) == document
    # What is taken out takes its own comments along.
    own = {"a key less": "side_faces =", "a table less": "[solver]"}.get(change)
    lost = set(comments(text)) - set(comments(found))
    assert lost <= (set() if own is None else set(comments(text[text.index(own) :])))


def test_many_changes_in_turn_are_in_the_text():
    text = starting_case()
    document = copy.deepcopy(tomllib.loads(text))
    for change in CHANGES.values():
        change(document) if change is not CHANGES["true for one"] else document.update(title="x")
        text = update_toml(document, text)
        assert tomllib.loads(text) == document
    assert "# " in text


@pytest.mark.parametrize(
    "text", ["", "# of another file", "[body # \n", "a.b = 1 # \na = 2", "# \n" + "a." * 5000 + "b = 1"]
)
def test_a_text_that_does_not_fit_is_left(text):
    document = tomllib.loads(starting_case())
    assert tomllib.loads(update_toml(document, text)) == document
    if "# of" not in text:
        assert update_toml(document, text) == to_toml(document)
