"""``--rexs``: bearings from other programs and to them."""

import pytest


def test_out_and_in_again(run, folder):
    run("new", "nu.toml", "--bearing")
    run("bearing", "nu.toml", "--set", "solver.method=slices", "--rexs", "nu.rexs.json")
    run("new", "again.toml", "--bearing", "--rexs", "nu.rexs.json")
    assert "nu.rexs" in run("bearing", "again.toml", "--rexs", "nu.rexs").out
    assert (folder / "nu.rexs").read_text().startswith("<?xml")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["new", "--rexs", "a.rexs"], "--rexs = 'a.rexs' must be given with --bearing"),
        (["new", "--bearing", "--component", "3"], "--component = 3 must be given with --rexs"),
        (["new", "--bearing", "--rexs", "none.rexs"], "--rexs = 'none.rexs' must be a file that can be read"),
        (["bearing", "nu.toml", "--rexs", "a.xml"], "--rexs = 'a.xml' must end with .rexs"),
        (["bearing", "nu.toml", "--rexs", "a.rexs", "--compare"], "--rexs = 'a.rexs' must not be given with --compare"),
        (["bearing", "nu.toml", "--rexs", "a/b/c.rexs"], "--rexs = 'a/b/c.rexs' must be in an existing folder"),
    ],
)
def test_refusals(words, sentence, run, folder):
    run("new", "nu.toml", "--bearing")
    assert sentence in run(*words, code=2).err
