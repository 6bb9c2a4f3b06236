"""A case as plain data: the call that solves it, its mirror image and its scaled twins.

Plain data is what the package and the checker both start from, so that neither reads the other's objects. A case is a
dictionary with the keys a, b (bodies), given (two of approach, load, tilt, moment), element and strips; a body is one
with its kind and its arguments; a profile is a list of parts, each with its name, arguments and shift.
"""

import math

import shapes
from own_theory import common_interval

import nonhertz as nh

LENGTHS = {
    "amplitude", "approach", "at", "centre", "depth", "diameter", "effective_length", "end_radius", "height", "length",
    "middle", "position", "radius", "reach", "relief", "straight", "width", "y", "zm",
}  # fmt: skip
ODD = {"angle", "at", "centre", "moment", "phase", "position", "side", "tilt"}  # change sign in a mirror
OF_SHAPES = {"Cusp", "Step", "Dimple", "Wave"}


def call_text(case):
    """The call that solves a case, as one would type it."""
    given = [f"{name}={value!r}" for name, value in case["given"].items()]
    return f"nh.solve({contact_text(case)}, {', '.join(given)}{_options_text(case)})"


def contact_text(case):
    return f"nh.Contact({_body_text(case['a'])}, {_body_text(case['b'])})"


def arguments(case):
    """Contact and keywords of `nonhertz.solve`, made from the text of the call, so that the text reproduces them."""
    contact = eval(contact_text(case), {"nh": nh, "shapes": shapes, "inf": math.inf})
    return contact, {**case["given"], "element": element(case), "strips": case["strips"]}


def element(case):
    return nh.PARABOLIC if case["element"] == "parabolic" else nh.SEMI_ELLIPTIC


def _options_text(case):
    text = "" if case["element"] == "semi-elliptic" else ", element=nh.PARABOLIC"
    return text if case["strips"] is None else f"{text}, strips={case['strips']!r}"


def _body_text(body):
    # What a body leaves out, the checkers of a case take to be this.
    body = {"side_faces": "mirror", "depth": "plane-strain" if body["kind"] == "Roller" else "none"} | body
    shown = [f"material=nh.Material({body['modulus']!r}, {body['poisson']!r})"]
    plain = ("length", "effective_length", "position", "side_faces", "images", "depth")
    shown += [f"{name}={body[name]!r}" for name in plain if name in body]
    diameter = body.get("diameter")
    if isinstance(diameter, dict):
        tabulated = f"y={tuple(diameter['y'])!r}, diameter={tuple(diameter['diameter'])!r}"
        shown.append(f"diameter=nh.TabulatedDiameter({tabulated})")
    elif diameter is not None:
        shown.append(f"diameter={diameter!r}")
    if body.get("profile"):
        shown.append("profile=" + " + ".join(_part_text(part) for part in body["profile"]))
    return f"nh.{body['kind']}({', '.join(shown)})"


def _part_text(part):
    given = ", ".join(f"{name}={value!r}" for name, value in part["with"].items())
    made = f"{'shapes' if part['of'] in OF_SHAPES else 'nh.profile'}.{part['of']}({given})"
    return made if not part.get("shift") else f"{made}.shifted({part['shift']!r})"


def mirrored(case):
    """The same bodies and loads seen from behind: y becomes -y."""
    strips = case["strips"]
    return {
        "a": _mirrored_body(case["a"]),
        "b": _mirrored_body(case["b"]),
        "given": {name: -value if name in ODD else value for name, value in case["given"].items()},
        "element": case["element"],
        "strips": [-edge for edge in strips[::-1]] if isinstance(strips, list) else strips,
    }


def _mirrored_body(body):
    found = dict(body)
    if "position" in body:
        found["position"] = -body["position"]
    if isinstance(body.get("side_faces"), tuple):
        found["side_faces"] = body["side_faces"][::-1]
    if isinstance(body.get("diameter"), dict):
        found["diameter"] = _reversed(body["diameter"], "diameter")
    found["profile"] = [_mirrored_part(part) for part in body.get("profile", [])]
    return found


def _mirrored_part(part):
    if part["of"] == "tabulated":
        given = _reversed(part["with"], "relief")
    else:
        odd = ODD - ({"angle"} if part["of"] != "conical" else set())
        given = {name: -value if name in odd else value for name, value in part["with"].items()}
    return {**part, "with": given, "shift": -part.get("shift", 0.0)}


def _reversed(table, values):
    return {**table, "y": [-y for y in table["y"][::-1]], values: table[values][::-1]}


def scaled(case, by):
    """The same shapes ``by`` times as large, at the same pressures."""
    powers = {"approach": 1, "load": 2, "tilt": 0, "moment": 3}
    twin = {
        "a": _scaled_body(case["a"], by),
        "b": _scaled_body(case["b"], by),
        "given": {name: value * by ** powers[name] for name, value in case["given"].items()},
        "element": case["element"],
    }
    strips = case["strips"]
    if isinstance(strips, list):
        # What ended with the bodies ends with them still, also after rounding.
        low, high = common_interval(twin)
        strips = [min(max(by * edge, low), high) for edge in strips]
    return {**twin, "strips": strips}


def _scaled_body(body, by):
    found = {name: _longer(name, value, by) for name, value in body.items() if name != "profile"}
    found["profile"] = [
        {
            "of": part["of"],
            "with": {name: _longer(name, value, by, by * by) for name, value in part["with"].items()},
            "shift": by * part.get("shift", 0.0),
        }
        for part in body.get("profile", [])
    ]
    return found


def _longer(name, value, by, load=1.0):
    if isinstance(value, dict):
        return {key: _longer(key, inner, by) for key, inner in value.items()}
    if name == "load":
        return value * load
    if name not in LENGTHS or value is None or isinstance(value, str):
        return value
    return [by * one for one in value] if isinstance(value, list) else by * value


def stiffened(case, by):
    """The same contact of materials ``by`` times as stiff, under ``by`` times the load."""
    found = {**case, "given": dict(case["given"])}
    for name in "ab":
        body = {**case[name], "modulus": by * case[name]["modulus"], "profile": []}
        for part in case[name].get("profile", []):
            given = dict(part["with"])
            if "load" in given:
                given["load"], given["compliance"] = by * given["load"], given["compliance"] / by
            body["profile"].append({**part, "with": given})
        found[name] = body
    for name in ("load", "moment"):
        if name in found["given"]:
            found["given"][name] *= by
    return found
