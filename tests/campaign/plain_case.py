"""A case as plain data, and the call that solves it.

Plain data is what the package and the checker both start from, so that neither reads the other's objects. A case is a
dictionary with the keys a, b (bodies), given (two of approach, load, tilt, moment), element and strips; a body is one
with its kind and its arguments; a profile is a list of parts, each with its name, arguments and shift.
"""

import math
import warnings

import shapes

import nonhertz as nh

OF_SHAPES = {"Cusp", "Step", "Dimple", "Wave"}


def call_text(case):
    """The call that solves a case, as one would type it."""
    given = [f"{name}={value!r}" for name, value in case["given"].items()]
    return f"nh.solve({contact_text(case)}, {', '.join(given)}{_options_text(case)})"


def contact_text(case):
    return f"nh.Contact({_body_text(case['a'])}, {_body_text(case['b'])})"


def arguments(case):
    """Contact and keywords of `nonhertz.solve`, made from the text of the call, so that the text reproduces them."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)  # materials as soft as cork are drawn, too
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
