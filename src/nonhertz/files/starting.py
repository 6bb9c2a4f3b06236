"""Files of cases and bearings to start from."""

from __future__ import annotations

from collections.abc import Iterable
from importlib import resources

from nonhertz.inputs.checks import one_of

#: Machine elements whose cases `starting_case` returns, by name, in words.
TEMPLATES = {
    "cylindrical": "cylindrical roller on a ring",
    "tapered": "tapered roller on a ring",
    "spherical": "barrel of a spherical roller bearing",
    "needle": "needle on a shaft",
    "wheel-on-rail": "crowned wheel on a rail",
    "gear-flank": "flanks of spur gears",
    "cam": "cam and roller follower",
}


def starting_case(template: str | None = None) -> str:
    """Return a commented case file to start from.

    Parameters
    ----------
    template : str, optional
        One of `TEMPLATES`, each an example of a machine element; by default one with all keys of a case file.

    Raises
    ------
    InputError
        If there is no such template.
    """
    return starting_text("starting_case.toml", template, TEMPLATES, "templates")


#: Bearings whose files `starting_bearing` returns, by name, in words.
BEARING_TEMPLATES = {
    "cylindrical": "cylindrical roller bearing",
    "needle": "needle roller bearing",
    "tapered-pair": "pair of tapered roller bearings",
    "spherical": "spherical roller bearing",
    "thrust": "cylindrical roller thrust bearing",
}


def starting_bearing(template: str | None = None) -> str:
    """Return a commented bearing file to start from.

    Parameters
    ----------
    template : str, optional
        One of `BEARING_TEMPLATES`, each an example of a kind of bearing; by default one with all keys of a bearing
        file.

    Raises
    ------
    InputError
        If there is no such template.
    """
    return starting_text("starting_bearing.toml", template, BEARING_TEMPLATES, "templates/bearings")


def starting_text(name: str, template: str | None = None, known: Iterable[str] = (), folder: str = "") -> str:
    """Return the text of a packaged file to start from: a template in a folder, or the file of a name.

    Raises
    ------
    InputError
        If the template is unknown.
    """
    if template is not None:
        one_of("template", template, tuple(known), "choose one of them")
        name = f"{folder}/{template}.toml"
    return resources.files("nonhertz.files").joinpath(name).read_text(encoding="utf-8")
