"""Requests of the page, sound ones changed at random, each reproducible from its number."""

import copy
import json
import random
import tomllib
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlencode

from case_texts import FILES, NUMBERS, WORDS, Mutator, sound_bearings, sound_texts

from nonhertz.files.measured import MeasuredProfile
from nonhertz.web.form.form import form

JSON, TOML, BINARY = "application/json", "application/toml", "application/octet-stream"
PATHS = {"/solve": 30, "/form": 20, "/open": 20, "/upload": 20, "/download/case.toml": 5, "/download/table.csv": 5}
PATHS |= {"/bearing/solve": 20, "/bearing/form": 5, "/bearing/download/bearing.toml": 2}
BARE: list[Any] = [None, True, 0, -1, 1e300, 1e-300, 2**70, "", [], {}, [[]], [None], {"kind": "crown"}, "x" * 5000]
BARE += [[0.5] * 2001, ["a"] * 300, {f"k{number}": number for number in range(41)}, "\ud800", "\u0000"]


@dataclass(frozen=True)
class Sent:
    """A request: where it goes, and what is in it."""

    path: str
    kind: str
    content: bytes


class Requests:
    """Makes requests from sound documents, files and their options."""

    def __init__(self) -> None:
        self.texts = sound_texts()
        self.documents = [json.loads(json.dumps(tomllib.loads(text))) for text in self.texts]
        for document in self.documents:
            for body in document["body"].values():
                tables = body.get("profile", [])
                if isinstance(tables, list):
                    body["profile"] = [table for table in tables if "file" not in table]
            assert form(document).members
        self.bearings = [json.loads(json.dumps(tomllib.loads(text))) for text in sound_bearings()]
        self.bearings = [each for each in self.bearings if "file" not in json.dumps(each["roller"])]

    def request(self, number: int) -> Sent:
        """Return the request of a number."""
        mutator = Mutator(number, self.texts)
        picked = mutator.random
        path = picked.choices(list(PATHS), list(PATHS.values()))[0]
        if path == "/open":
            return Sent(path, TOML, mutator.text().encode("utf-8", "surrogatepass"))
        if path == "/upload":
            return self.upload(mutator)
        of_bearing = path.startswith("/bearing")
        document = copy.deepcopy(picked.choice(self.bearings if of_bearing else self.documents))
        for _ in range(picked.choice([1, 1, 2, 5])):
            _change(document, picked)
        asked: dict[str, Any] = {"document": document}
        if path == "/solve":
            asked |= {"stress": picked.choice([True, False, False, False, 1]), "body": picked.choice("aaabx")}
        if of_bearing:
            asked["method"] = picked.choice(["slices"] * 9 + ["magic"])
        text = json.dumps(asked)
        if picked.random() < 0.1:
            text = picked.choice([mutator.characters, mutator.cut, mutator.copy, mutator.number])(text)
        kind = JSON if picked.random() < 0.98 else picked.choice([TOML, BINARY, "", "text/plain", f"{JSON}; charset=x"])
        return Sent(path, kind, text.encode("utf-8", "surrogatepass"))

    def upload(self, mutator: Mutator) -> Sent:
        """Return a request with a measured file."""
        picked = mutator.random
        text = picked.choice(list(FILES.values()))
        for _ in range(picked.choice([0, 1, 2])):
            text = picked.choice([mutator.characters, mutator.cut, mutator.copy, mutator.number, mutator.line])(text)
        options = {"name": picked.choice(["x.txt", "", "a" * 300, "ü\n"])}
        for _ in range(picked.choice([0, 1, 2])):
            words = [*NUMBERS[:25], *WORDS, "um", "mm", "spline", "true", "false", "[]"]
            options[picked.choice([*MeasuredProfile.descriptions, "colour"])] = picked.choice(words)
        content = text.encode(picked.choice(["utf-8", "utf-8", "utf-16", "latin-1"]), "replace")
        return Sent(f"/upload?{urlencode(options)}", BINARY, content)


def _change(document: dict[str, Any], picked: random.Random) -> None:
    """Replace, rename, repeat or take away one entry somewhere in a document."""
    places: list[tuple[Any, Any]] = []
    waiting: list[Any] = [document]
    while waiting:
        table = waiting.pop()
        keys = list(table) if isinstance(table, dict) else range(len(table))
        places += ((table, key) for key in keys)
        waiting += (table[key] for key in keys if isinstance(table[key], dict | list))
    table, key = picked.choice(places or [(document, "title")])
    match picked.randrange(8):
        case 0:
            del table[key]
        case 1 if isinstance(table, dict):
            table[picked.choice([str(key)[:-1], f"{key}x", "", "ü", "length", "radius"])] = table.pop(key)
        case 2 if isinstance(table, list):
            table += copy.deepcopy([table[key]]) * picked.choice([1, 2, 19, 20, 21, 40])
        case 3 | 4:
            table[key] = picked.choice([-1, 1]) * 10 ** picked.uniform(-9, 9)
        case 5:
            table[key] = picked.choice(WORDS).replace("\\u0020", " ")
        case _:
            table[key] = copy.deepcopy(picked.choice(BARE))
