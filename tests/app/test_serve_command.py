"""`nonhertz serve`: where it listens, what it begins with, how it ends."""

import json
import socket
import tomllib

import numpy as np
import pytest

from nonhertz.cli import main
from nonhertz.cli.serve import starting_document
from nonhertz.files.casefile import read_case
from nonhertz.files.starting import starting_case
from nonhertz.show.solving import solve_case
from nonhertz.web import limits
from nonhertz.web.server import serving
from nonhertz.web.view import jobs

CASE = """
[body.a]
kind = "roller"
diameter = 20.0
length = 20.0
profile = [{ kind = "crown", radius = 9000.0 }, { kind = "tabulated", file = "points.csv", scale = 2.0 }]
[body.b]
profile = { kind = "tabulated", file = "points.csv", interpolation = "linear" }
[load]
load = "20 kN"
"""


@pytest.fixture
def case(tmp_path):
    (tmp_path / "points.csv").write_text("-12, 0.004\n0, 0\n12, 0.004\n")
    path = tmp_path / "my case.toml"
    path.write_text(CASE)
    return path


def test_without_a_file_it_begins_with_that_of_new():
    assert starting_document(None) == (tomllib.loads(starting_case()), (), starting_case())


def test_files_that_a_case_names_become_points(case):
    document, notes, _ = starting_document(case)
    assert document["title"] == "my case"
    assert notes == (
        "body.a.profile[2]: the page contains the 3 points of points.csv.",
        "body.b.profile[1]: the page contains the 3 points of points.csv.",
    )
    points = {"kind": "tabulated", "y": [-12.0, 0.0, 12.0], "relief": [0.004, 0.0, 0.004]}
    assert document["body"]["a"]["profile"][1] == points | {"interpolation": "pchip", "scale": 2.0}
    assert document["body"]["b"]["profile"] == [points | {"interpolation": "linear"}]
    read = json.loads(jobs.solve(document, False, "a"))
    assert read["key"]["approach"] == solve_case(read_case(case)).approach


def test_of_many_points_some_are_kept(case):
    y = np.linspace(-12.0, 12.0, 5001)
    text = "\n".join(f"{a}, {b}" for a, b in zip(y, 1e-5 * y**2, strict=True))
    (case.parent / "points.csv").write_text(text)
    document, notes, _ = starting_document(case)
    kept = document["body"]["b"]["profile"][0]["y"]
    assert len(kept) <= limits.POINTS
    assert (kept[0], kept[-1]) == (-12.0, 12.0)
    assert "the 5001 points of points.csv, of which every 3rd is kept." in notes[0]


def test_a_case_that_the_page_does_not_take_is_refused(case, run):
    case.write_text(CASE + "[solver]\nstrips = 2000\n")
    assert (
        "solver.strips = 2000 must be at most 300 on the page: use the command line for more."
        in run("serve", str(case), "--no-browser", code=2).err
    )


def test_a_port_that_is_taken(capsys):
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        assert main(["serve", "--port", str(port), "--no-browser"]) == 2
    error = capsys.readouterr().err
    remedy = "choose another, or 0 for a free one"
    assert error == f"--port = {port} must be free (address already in use): {remedy}.\n"


def test_it_listens_on_this_machine_alone():
    with serving.open_socket(0) as bound:
        assert bound.getsockname()[0] == "127.0.0.1"


@pytest.mark.parametrize("browser", [True, False])
def test_it_tells_its_address_and_opens_a_browser_if_wanted(browser, monkeypatch, capsys, run):
    opened = []

    class Ended:
        def run(self, sockets):
            raise KeyboardInterrupt

    monkeypatch.setattr(serving, "server_of", lambda app: Ended())
    monkeypatch.setattr(serving.threading, "Thread", lambda target, args, daemon: opened.append(args) or Started())
    code = main(["serve", "--port", "0", *([] if browser else ["--no-browser"])])
    assert code == 130
    out, error = capsys.readouterr()
    assert out.startswith("The page is at http://127.0.0.1:")
    assert error == "Interrupted.\n"
    assert [address for (address,) in opened] == [out.split()[4]] * browser


def test_it_ends_as_interrupted_where_a_shell_has_interrupts_ignored(monkeypatch, run):
    class Ended:
        def run(self, sockets):
            """Return, as after an interrupt that the process ignores."""

    monkeypatch.setattr(serving, "server_of", lambda app: Ended())
    assert run("serve", "--port", "0", "--no-browser", code=130).err == "Interrupted.\n"


class Started:
    def start(self):
        pass
