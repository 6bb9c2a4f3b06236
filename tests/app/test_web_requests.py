"""The page's server: what it answers, and whom it does not."""

import contextlib
import json
import re
import socket
import threading
import tomllib

import anyio
import httpx
import numpy as np
import pytest
from numpy.testing import assert_allclose
from serving import post, raw, running
from test_web_units import US_ALONE, texts

import nonhertz as nh
from nonhertz.files.casefile import read_case
from nonhertz.files.starting import starting_case
from nonhertz.web import limits
from nonhertz.web.form.ranges import form_state
from nonhertz.web.server import app, intake, serving, workers
from nonhertz.web.server.guard import HEADERS
from nonhertz.web.server.guard import UNITS as HEADER
from nonhertz.web.view import jobs

STARTING = tomllib.loads(starting_case())
JSON = {"content-type": "application/json"}
BINARY = {"content-type": "application/octet-stream"}


@pytest.fixture(scope="module")
def page():
    with (
        running(STARTING) as port,
        httpx.Client(base_url=f"http://127.0.0.1:{port}", timeout=workers.WARM_UP_SECONDS) as made,
    ):
        yield made


@pytest.fixture
def client(page):
    """Return a client of the one page, once its process is free: a test before may have had it ended and replaced."""
    post(page, "/open", content=b"", headers={"content-type": "application/toml"})
    return page


def refused(response, status):
    """Return the sentence of a refusal."""
    assert response.status_code == status, response.text
    body = response.json()
    assert body["ok"] is False
    (mistake,) = body["mistakes"]
    assert mistake["path"] == ""
    assert mistake["sentence"].endswith(".")
    assert "Traceback" not in response.text
    return mistake["sentence"]


def test_the_page_has_its_case_and_form(client):
    response = client.get("/")
    assert response.status_code == 200
    start = json.loads(re.search(r'<script type="application/json" id="start">(.*?)</script>', response.text, re.S)[1])
    assert start["document"] == STARTING
    assert start["version"] == nh.__version__
    assert start["limits"] == {
        "upload_bytes": limits.UPLOAD_BYTES,
        "document_bytes": limits.DOCUMENT_BYTES,
        "strips": limits.STRIPS,
    }
    assert start["form"]["schema"]["properties"]["body"]
    assert start["form"]["state"] == form_state(STARTING, "case")


def test_a_case_cannot_leave_the_script_that_it_starts_in():
    evil = {"title": "</script><script>alert(1)</script><!--"}
    with running(evil, workers=0) as port:
        text = httpx.get(f"http://127.0.0.1:{port}/").text
    assert "<script>alert" not in text
    assert "<!--" not in text[text.index('id="start"') : text.index("</head>")]


def test_all_answers_have_the_headers(client):
    for response in (
        client.get("/"),
        client.get("/nothing"),
        client.post("/solve"),
        client.get("/", headers={"host": "x"}),
    ):
        for name, value in HEADERS.items():
            if name != "Cache-Control":
                assert response.headers[name] == value
        assert "server" not in response.headers
        assert not [name for name in response.headers if name.startswith("access-control")]
    assert "script-src 'self'" in HEADERS["Content-Security-Policy"]
    assert "unsafe-eval" not in HEADERS["Content-Security-Policy"]


def test_solving(client):
    response = client.post("/solve", json={"document": STARTING, "stress": True, "body": "b"})
    assert response.status_code == 200
    case = tomllib.loads(starting_case())
    alone = json.loads(jobs.solve(case, True, "b"))
    found = response.json()
    assert found.pop("ms") > 0.0
    del alone["ms"]
    # Another process, but the same machine.
    assert found == alone


def test_addresses_of_pages_may_end_in_a_slash(client):
    for path in ("/bearing", "/contact"):
        answer = client.get(f"{path}/", follow_redirects=True)
        assert answer.status_code == 200
        assert answer.url.path == path, "from where the addresses of scripts and styles are right"


def test_files_of_the_page_are_sent_once(client):
    first = client.get("/static/page.css")
    assert first.headers["cache-control"] == "no-cache"
    again = client.get("/static/page.css", headers={"if-none-match": first.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    assert client.get("/status").headers["cache-control"] == "no-store"


def test_a_mistaken_case_is_answered_and_shown(client):
    document = STARTING | {"load": {"load": "20 kg"}}
    response = client.post("/solve", json={"document": document})
    assert response.status_code == 200
    assert [mistake["path"] for mistake in response.json()["mistakes"]] == ["load.load"]
    form = client.post("/form", json={"document": document})
    assert form.status_code == 200
    assert form.json() == form_state(document, "case")


def test_opening_a_case_file(client):
    response = client.post("/open", content=starting_case(), headers={"content-type": "application/toml"})
    found = response.json()
    assert found.pop("ms") >= 0.0
    assert found == {"ok": True, "document": STARTING, "text": starting_case()}


NESTED = "The file must be a case file: lists or tables are nested too deeply."


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("title = ", "The file must be valid TOML: invalid value (at end of document)."),
        (b"title = '\xff'", "The file must be text in UTF-8: save it with that encoding."),
        ("a = " + "[" * 5000, "The file must be valid TOML: lists or tables are nested too deeply."),
        ("a = " + "9" * 5000, "The file must be valid TOML: a number has thousands of digits."),
        (".".join("a" * 5000) + " = 1", NESTED),
        ("[" + '."b c" . '.join("a" * 17) + "]", NESTED),
        ("a = " + "{a = " * 17 + "1" + "}" * 17, NESTED),
    ],
)
def test_opening_what_is_no_case_file(client, text, words):
    response = client.post("/open", content=text, headers={"content-type": "application/toml"})
    assert refused(response, 200) == words


@pytest.mark.parametrize(
    ("text", "document"),
    [
        ("title = 2026-01-01", {"title": "2026-01-01"}),
        *((f"a = {number}", {"a": "inf"}) for number in ("9" * 4000, "0x" + "f" * 20_000, "inf")),
        ("a = nan", {"a": "nan"}),
    ],
)
def test_opening_what_json_has_not(client, text, document):
    response = client.post("/open", content=text, headers={"content-type": "application/toml"})
    assert response.json()["document"] == document


def test_downloads(client, tmp_path):
    def download(name):
        response = client.post(f"/download/{name}", json={"document": STARTING})
        assert response.status_code == 200, response.text
        stem = "logarithmic-roller-20-x-20-on-a-plate"
        file = f"{stem}.toml" if name == "case.toml" else f"{stem}-{name}"
        assert response.headers["content-disposition"] == f'attachment; filename="{file}"'
        return response.content

    path = tmp_path / "case.toml"
    path.write_bytes(download("case.toml"))
    assert tomllib.loads(path.read_text()) == STARTING
    case = read_case(path)
    solution = nh.solve(case.contact, **case.prescribed.keywords)
    assert json.loads(download("result.json"))["approach"] == solution.approach
    table = np.loadtxt(download("table.csv").decode().splitlines(), delimiter=",", skiprows=1)
    # Written with all digits.
    assert_allclose(table[:, 3], solution.centre_pressure, rtol=1e-15)


def test_downloads_of_a_mistaken_case(client):
    document = STARTING | {"load": {}}
    for name in ("table.csv", "result.json"):
        response = client.post(f"/download/{name}", json={"document": document})
        assert response.status_code == 422
        assert response.json()["mistakes"][0]["path"] == "load.load"
    kept = client.post("/download/case.toml", json={"document": document})
    assert tomllib.loads(kept.text) == document, "what is mistaken can be kept for later all the same"
    without = client.post("/download/case.toml", json={"document": {"title": None}})
    assert without.status_code == 422


def test_names_of_downloads_are_plain(client):
    evil = 'a"; filename=../../etc/passwd\r\nX: y\u202e.exe'
    response = client.post("/download/case.toml", json={"document": {"title": evil}})
    assert response.headers["content-disposition"] == 'attachment; filename="a-filename-etc-passwd-x-y-exe.toml"'
    assert "x" not in response.headers
    nameless = client.post("/download/case.toml", json={"document": {"title": "..//\u00fc"}})
    assert nameless.headers["content-disposition"] == 'attachment; filename="case.toml"'


@pytest.mark.parametrize("kind", ["crown", "flat"])
def test_uploading_a_measured_profile(client, kind):
    y = np.linspace(0.0, 20.0, 2001)
    height = -((y - 10.0) ** 2) / 2.0 / 4000.0 if kind == "crown" else 0.0 * y
    noise = 2e-5 * np.random.default_rng(1).standard_normal(y.size)
    text = "\n".join(f"{a:.4f} {1e3 * b:.5f}" for a, b in zip(y, height + noise, strict=True))
    query = {"name": "roller.txt", "height_unit": "um", "smooth": "gaussian", "cutoff": "0.8"}
    response = client.post("/upload", params=query, content=text.encode(), headers=BINARY)
    found = response.json()
    assert found["ok"], found
    assert found["name"] == "roller.txt"
    assert len(found["table"]["y"]) == len(found["table"]["relief"]) <= 300
    names = [panel["name"] for panel in found["steps"]["panels"]]
    assert names[0] == "level"
    assert "smooth" in names
    assert [row[0] for row in found["roughness"]] == ["Ra", "Rq", "Rz", "cutoff"]
    profile = [found["table"]]
    answer = client.post(
        "/solve", json={"document": STARTING | {"body": STARTING["body"] | {"b": {"profile": profile}}}}
    )
    assert answer.json()["ok"], answer.text
    # A step is taken back by asking without it.
    rough = client.post("/upload", params=query | {"smooth": "false"}, content=text.encode(), headers=BINARY).json()
    assert "smooth" not in [panel["name"] for panel in rough["steps"]["panels"]]


@pytest.mark.parametrize(
    ("query", "path"),
    [({"cutoff": "wide"}, "upload.cutoff"), ({"colour": "1"}, "upload.colour"), ({"sense": "up"}, "upload.sense")],
)
def test_uploading_with_mistaken_options(client, query, path):
    response = client.post("/upload", params=query, content=b"1 2\n3 4\n", headers=BINARY)
    assert [mistake["path"] for mistake in response.json()["mistakes"]] == [path]


@pytest.mark.parametrize(
    "content", [b"", b"\x00" * 1000, b"PK\x03\x04" + b"x" * 100, b"hello\n", b"1 2\n", b"\xff\xfe"]
)
def test_uploading_what_is_no_profile(client, content):
    found = client.post("/upload", params={"name": "x"}, content=content, headers=BINARY).json()
    assert not found["ok"]
    assert found["mistakes"][0]["path"].partition(".")[0] == "upload"


@pytest.mark.slow
def test_of_more_points_than_the_page_takes_neighbours_are_averaged(client, monkeypatch):
    y = np.linspace(-10.0, 10.0, 2 * limits.UPLOAD_POINTS + 1)
    text = "\n".join(f"{a:.5f} {b:.5f}" for a, b in zip(y, -(y**2) / 8.0, strict=True))  # a crown of 4000 mm, in um
    found = client.post("/upload", params={"height_unit": "um"}, content=text.encode(), headers=BINARY).json()
    assert found["notes"][-1].startswith(f"Groups of 3 of the {len(y)} points were averaged")
    # The heights were written to a hundredth of a nanometre, and a filter leaves a parabola but for a constant.
    table = {name: np.array(found["table"][name]) for name in ("y", "relief")}
    curve = np.polynomial.Polynomial.fit(table["y"], table["relief"], 2).convert()
    assert_allclose(curve.coef[2], 1.0 / 8000.0, rtol=1e-3)


async def too_slow(self, job, *arguments, seconds):
    assert seconds == limits.ANSWER_SECONDS
    raise workers.TooSlowError


@pytest.mark.parametrize(
    ("path", "sent", "command"),
    [
        ("/solve", {"json": {"document": STARTING}}, "solve"),
        ("/upload", {"content": b"1 2\n" * 1000, "headers": BINARY}, "profile"),
    ],
)
def test_what_takes_too_long_is_given_up(client, monkeypatch, path, sent, command):
    monkeypatch.setattr(workers.Workers, "run", too_slow)
    sentence = f"This takes longer than the page waits: use 'nonhertz {command}'."
    response = client.post(path, **sent)
    assert response.status_code == 200
    assert response.json() == {"ok": False, "slow": True, "mistakes": [{"path": "", "sentence": sentence}]}


@pytest.mark.parametrize(
    "path",
    [
        "/static/../app.py",
        "/static/..%2fapp.py",
        "/static/%2e%2e/app.py",
        "/static/..%5capp.py",
        "/static//etc/passwd",
        "/static/page.css%00.js",
        "/templates/case.html",
        "/download/..%2fcase.toml",
    ],
)
def test_no_other_file_is_sent(client, path):
    port = client.base_url.port
    status, body = raw(port, "GET", path, {"host": f"127.0.0.1:{port}"})
    assert status == 404
    assert json.loads(body)["ok"] is False


SITES = ("cross-site", "same-site", "anything")
OTHERS = [
    *({"host": host} for host in ("127.0.0.1", "evil.example:{0}", "127.0.0.1.evil:{0}", "[::1]:{0}", "")),
    *(
        {"origin": origin}
        for origin in (
            "http://evil.example", "null", "https://127.0.0.1:{0}", "http://127.0.0.1", "127.0.0.1:{0}", "file://"
        )
    ),
    *({"sec-fetch-site": site} for site in SITES),
    *({"sec-fetch-site": site, "sec-fetch-mode": "no-cors"} for site in SITES),
    *({"sec-fetch-site": site, "sec-fetch-mode": "navigate", "sec-fetch-dest": "iframe"} for site in SITES),
]  # fmt: skip


@pytest.mark.parametrize("headers", OTHERS, ids=str)
def test_others_are_refused(client, headers):
    headers = {name: value.format(client.base_url.port) for name, value in headers.items()}
    refused(client.post("/solve", json={"document": STARTING}, headers=headers), 403)
    refused(client.get("/static/icon.svg", headers=headers), 403)


def test_two_hosts_and_none_are_refused_and_links_followed(client):
    port = client.base_url.port
    assert raw(port, "GET", "/", {})[0] == 400  # by the HTTP library
    own = f"127.0.0.1:{port}"
    assert raw(port, "GET", "/", {"host": own, "Host": own})[0] in {400, 403}
    twice = [("sec-fetch-site", "same-origin"), ("sec-fetch-site", "cross-site")]
    refused(client.get("/status", headers=twice), 403)
    link = {"sec-fetch-site": "cross-site", "sec-fetch-mode": "navigate", "sec-fetch-dest": "document"}
    for path in ("/", "/contact", "/bearing"):
        assert client.get(path, headers=link).status_code == 200
    refused(client.get("/status", headers=link), 403)
    refused(client.get("/", headers=link | {"sec-fetch-dest": "iframe"}), 403)


POSTS = ["/solve", "/form", "/curve", "/download/case.toml"]
OF_BEARINGS = ["/bearing/solve", "/bearing/contact"]


@pytest.mark.parametrize("kind", ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data", ""])
def test_what_a_foreign_form_could_send_is_refused(client, kind):
    for path in (*POSTS, "/open", "/upload"):
        refused(client.post(path, content=b"{}", headers={"content-type": kind}), 415)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "null",
        "[" * 100_000,
        '{"document": ' + "[" * 30 + "]" * 30 + "}",
        '{"document": {"a": NaN}}',
        '{"document": {"a": Infinity}}',
        '{"document": {"a": 1, "a": 2}}',
        '{"document": {"a": ' + "9" * 5000 + "}}",
        '{"document": {"a": "\ud800"}}'.encode("utf-8", "surrogatepass"),
        b"\xff\xfe",
        "{}",
        '{"document": []}',
        '{"document": {}, "x": "' + "\x00" + '"}',
        '{"document": {"\\udfff": 1}}',
    ],
    ids=range(15),
)
def test_malformed_requests(client, text):
    for path in POSTS + OF_BEARINGS:
        refused(client.post(path, content=text, headers=JSON), 400)


LOAD = {"path": "load.load"}


@pytest.mark.parametrize(
    ("path", "wishes"),
    [
        ("/solve", [{"stress": 1}, {"stress": None}, {"body": "c"}, {"body": ["a"]}, {"body": 1}]),
        ("/strength", [{"body": "c"}, {"body": ["a"]}, {"body": 1}]),
        ("/curve", [{}, LOAD, {"values": [1.0]}, {"path": 1, "values": [1.0]}, LOAD | {"values": 1.0}]),
        ("/curve", [LOAD | {"values": values} for values in (
            [], [1.0] * (limits.CURVE_POINTS + 1), ["1"], [True], [10**400], [[1.0]],
        )]),
        ("/bearing/solve", [{"method": "magic"}, {"method": ["slices"]}]),
        ("/bearing/contact", [{}, {"roller": 0}, {"roller": True, "ring": "inner"}, {"roller": 0, "ring": "c"}]),
    ],
)  # fmt: skip
def test_malformed_wishes(client, path, wishes):
    for wish in wishes:
        refused(client.post(path, json={"document": STARTING} | wish), 400)


def test_too_much_is_refused(client):
    for path in POSTS:
        refused(client.post(path, content=b" " * (limits.DOCUMENT_BYTES + 1), headers=JSON), 413)
    refused(client.post("/upload", content=b" " * (limits.UPLOAD_BYTES + 1), headers=BINARY), 413)
    toml = {"content-type": "application/toml"}
    refused(client.post("/open", content=b" " * (limits.DOCUMENT_BYTES + 1), headers=toml), 413)


def test_a_body_is_not_read_to_its_end(client):
    """What a request says of its length is not believed, and one that never ends is cut off."""
    sent = 0

    def endless():
        nonlocal sent
        while True:
            sent += 1
            yield b" " * 65536

    with contextlib.suppress(httpx.TransportError):  # the server may have gone before its answer is read
        refused(client.post("/form", content=endless(), headers=JSON), 413)
    assert sent * 65536 < 100 * limits.DOCUMENT_BYTES


def test_what_arrives_too_slowly_is_given_up(client, monkeypatch):
    """Neither a body nor a head that trickles in holds a connection for long."""
    monkeypatch.setattr(intake, "BODY_SECONDS", 0.1)
    monkeypatch.setattr(serving, "HEAD_SECONDS", 0.1)
    head = f"POST /form HTTP/1.1\r\nHost: {client.base_url.netloc.decode()}\r\n"
    body = head + "Content-Type: application/json\r\nContent-Length: 1000\r\n\r\n{"
    ends = []
    for text in (head, body):
        with socket.create_connection(("127.0.0.1", client.base_url.port), timeout=30.0) as line:
            line.sendall(text.encode())
            ends.append(b"".join(iter(lambda: line.recv(65536), b"")))
    assert ends[0] == b""
    assert ends[1].startswith(b"HTTP/1.1 408 ")
    assert b"took too long to arrive" in ends[1]


def test_long_headers_that_arrive_at_once_are_refused_by_the_page():
    async def ask():
        page = httpx.ASGITransport(app.application(STARTING, 80, workers=0))
        async with httpx.AsyncClient(transport=page, base_url="http://127.0.0.1:80") as asking:
            long = {"host": "127.0.0.1:80", "x": "y" * limits.HEADER_BYTES}
            return await asking.get("/", headers=long)

    assert refused(anyio.run(ask), 431) == "The headers of the request are too long."


def test_methods_and_addresses(client):
    for path in ("/solve", "/form", "/open", "/upload", "/download/case.toml"):
        refused(client.get(path), 405)
        refused(client.put(path, content=b"{}", headers=JSON), 405)
    refused(client.post("/", content=b"{}", headers=JSON), 405)
    refused(client.get("/nothing/"), 404)
    refused(client.post("/download/passwd", json={"document": {}}), 404)
    assert client.options("/solve").status_code == 405
    typed = client.get("/bearings", headers={"accept": "text/html,application/xhtml+xml"})
    assert (typed.status_code, typed.text) == (404, "There is nothing at this address.")


@pytest.mark.slow
def test_more_than_can_wait_is_told_to_come_again(client, monkeypatch):
    monkeypatch.setattr(workers, "WAITING_REQUESTS", 2)
    document = STARTING | {"solver": {"strips": limits.STRIPS}}
    document["body"] = {
        name: body | {"length": 20.0, "images": limits.IMAGES} for name, body in STARTING["body"].items()
    }
    found = []

    def ask():
        found.append(httpx.post(client.base_url.join("/solve"), json={"document": document}, timeout=60.0))

    threads = [threading.Thread(target=ask) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert {response.status_code for response in found} == {200, 503}
    assert {response.headers["retry-after"] for response in found if response.status_code == 503} == {"1"}
    assert post(client, "/solve", json={"document": STARTING}).json()["ok"], "and then it goes on"


async def mistaken(self, job, *arguments, seconds):
    raise TypeError("an error of ours")


def test_an_error_of_ours_is_told_without_a_traceback(client, monkeypatch):
    monkeypatch.setattr(workers.Workers, "run", mistaken)
    # On a connection of its own, which the server closes after an error.
    response = httpx.post(client.base_url.join("/solve"), json={"document": STARTING})
    assert response.status_code == 500
    assert response.json()["internal"]
    assert "error in nonhertz (an error of ours)" in response.json()["mistakes"][0]["sentence"]
    assert "Traceback" not in response.text
    assert response.headers["x-content-type-options"] == "nosniff"


@pytest.mark.slow
def test_each_request_has_units_of_its_own(client):
    told = [client.post("/solve", json={"document": STARTING}, headers=headers) for headers in (US_ALONE, {}, US_ALONE)]
    assert [each.status_code for each in told] == [200] * 3
    first, second, third = (" ".join(texts(each.json())) for each in told)
    assert "ksi" in first
    assert "MPa" not in first
    assert "ksi" not in second
    assert "MPa" in second
    assert first == third


def test_other_units_are_refused(client):
    answer = client.post("/solve", json={"document": STARTING}, headers={HEADER: "imperial"})
    assert answer.status_code == 400
    assert answer.json()["mistakes"][0]["sentence"] == "The units must be 'si' or 'us'."
