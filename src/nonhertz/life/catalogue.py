"""The fatigue models that are integrals over the stressed volume, by name.

All of them give the probability S that a volume V survives N passes of the load, e the Weibull slope:

    ln(1/S) ~ N^e int <s - s_u>^k / z^h dV

s is the stress at a point at depth z over a pass, s_u a limit below which it does no damage. At a fixed probability the
life is proportional to the integral to the power -1/e, so that lives are compared without the unknown constant of
proportionality. The models differ in s, k, h and s_u.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Annotated, Any

from nonhertz.errors import InputError
from nonhertz.inputs.checks import not_negative, number_that, positive, text
from nonhertz.inputs.descriptions import Quantity, Word
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.life.lamina import LaminaModel, iso_16281

LINE_CONTACT_SLOPE = 9.0 / 8.0
SLOPES = 0.2, 5.0  # far beyond any measured value; powers stay within double precision
MOST_EXPONENT = 60.0
STRESSES = ("orthogonal_shear", "shear", "von_mises")

_EXPONENT_REMEDY, SLOPE_REMEDY = "give a positive number", "give Weibull's slope, 9/8 for line contacts"


#: Weibull slopes of bearings.
weibull_slope = number_that(
    lambda slope: SLOPES[0] <= slope <= SLOPES[1], f"lie between {SLOPES[0]:g} and {SLOPES[1]:g}", positive
)
_exponent = number_that(lambda value: value <= MOST_EXPONENT, f"not exceed {MOST_EXPONENT:g}", positive)


@input_class()
class VolumeModel(Input):
    """A fatigue model as an integral over the stressed volume, made by the functions of this module."""

    name: Annotated[str, Word("the name that files and commands use", "give the name of the model", condition=text)]
    stress: Annotated[
        str,
        Word(
            "'orthogonal_shear' (half its range over a pass where the field is symmetric), 'shear' (maximum shear) or "
            "'von_mises', the largest over a pass",
            "choose the stress that causes fatigue",
            STRESSES,
        ),
    ]
    exponent: Annotated[float, Quantity("", "k of the stress", _exponent, _EXPONENT_REMEDY)]
    depth_exponent: Annotated[
        float, Quantity("", "h of the depth", not_negative, "give 0 for no influence of the depth")
    ]
    slope: Annotated[float, Quantity("", "e of Weibull's distribution", weibull_slope, SLOPE_REMEDY)]
    fatigue_limit: Annotated[float, Quantity("MPa", "s_u", not_negative, "give a limit in MPa, 0 for none")]
    source: Annotated[str, Word("where it was published", "give its publication", condition=text)]

    @cross_check("stress", "exponent", "depth_exponent")
    def _check_surface(self) -> None:
        if self.depth_exponent >= 1.0 and self.stress != "orthogonal_shear":
            condition = "be 'orthogonal_shear' where depth_exponent is 1 or more"
            remedy = "other stresses do not vanish on the surface, where the integral diverges"
            raise InputError("stress", self.stress, condition, remedy)
        # Just below the surface orthogonal shear vanishes at least as fast as the square root of the depth.
        if self.depth_exponent >= 1.0 and 0.5 * self.exponent <= self.depth_exponent - 1.0:
            condition = f"be less than {1.0 + 0.5 * self.exponent:g}, or the integral diverges at the surface"
            raise InputError("depth_exponent", self.depth_exponent, condition, "give 7/3, or a larger stress exponent")


def lundberg_palmgren(
    *, slope: float = LINE_CONTACT_SLOPE, exponent: float = 31.0 / 3.0, depth_exponent: float = 7.0 / 3.0
) -> VolumeModel:
    """Return the model of Lundberg and Palmgren: orthogonal shear, less severe at larger depth.

    Parameters
    ----------
    slope : float
        e [-]: 9/8 for line contacts, 10/9 for point contacts.
    exponent, depth_exponent : float
        c and h [-].

    Notes
    -----
    Lundberg and Palmgren used the largest stress and its depth for the whole volume; here, as with Ioannides and
    Harris, every point has its own. The exponents of load and length are the same: in a uniform line contact life is
    proportional to the load to the power -(c - h + 1) / (2 e), which is -4.

    References
    ----------
    G. Lundberg, A. Palmgren, Dynamic capacity of rolling bearings, Acta Polytechnica, Mechanical Engineering Series
    1(3), 1947; Dynamic capacity of roller bearings, 2(4), 1952.
    """
    source = "Lundberg & Palmgren 1947, 1952"
    return VolumeModel("lundberg-palmgren", "orthogonal_shear", exponent, depth_exponent, slope, 0.0, source)


def ioannides_harris(
    *,
    fatigue_limit: float = 360.0,
    slope: float = LINE_CONTACT_SLOPE,
    exponent: float = 31.0 / 3.0,
    depth_exponent: float = 7.0 / 3.0,
    stress: str = "orthogonal_shear",
) -> VolumeModel:
    """Return the model of Ioannides and Harris: Lundberg and Palmgren's with a fatigue limit.

    Parameters
    ----------
    fatigue_limit : float
        s_u [MPa], for the amplitude of the orthogonal shear stress unless ``stress`` is another: 360 is used for
        bearing steel, and corresponds to a Hertz pressure of about 1500 MPa. The existence of a limit is disputed.
    slope, exponent, depth_exponent : float
        e, c and h [-].
    stress : str
        The stress that causes fatigue; any other than orthogonal shear needs a ``depth_exponent`` below 1.

    References
    ----------
    E. Ioannides, T. A. Harris, A new fatigue life model for rolling bearings, Journal of Tribology 107 (1985) 367-378,
    doi:10.1115/1.3261081. The limit: G. E. Morales-Espejel, J. Felix-Quinonez, Tribology International 2023, Table 3.
    """
    source = "Ioannides & Harris 1985"
    return VolumeModel("ioannides-harris", stress, exponent, depth_exponent, slope, fatigue_limit, source)


def zaretsky(
    *, slope: float = LINE_CONTACT_SLOPE, stress_life_exponent: float = 9.0, stress: str = "shear"
) -> VolumeModel:
    """Return the model of Zaretsky: maximum shear, no influence of depth, a stress-life exponent independent of slope.

    Parameters
    ----------
    slope : float
        e [-].
    stress_life_exponent : float
        c [-]; the integrand is the stress to the power c e, so that life varies with the power c for any slope.
    stress : str
        The stress that causes fatigue.

    References
    ----------
    E. V. Zaretsky, Fatigue criterion to system design, life, and reliability, Journal of Propulsion and Power 3 (1987)
    76-83, doi:10.2514/3.22954.
    """
    positive("stress_life_exponent", stress_life_exponent, _EXPONENT_REMEDY)
    weibull_slope("slope", slope, SLOPE_REMEDY)
    return VolumeModel("zaretsky", stress, stress_life_exponent * slope, 0.0, slope, 0.0, "Zaretsky 1987")


def weibull(*, slope: float = LINE_CONTACT_SLOPE, exponent: float = 31.0 / 3.0, stress: str = "shear") -> VolumeModel:
    """Return the model of Weibull: stress and volume alone.

    Parameters
    ----------
    slope : float
        e [-].
    exponent : float
        c [-].
    stress : str
        The stress that causes fatigue.

    References
    ----------
    W. Weibull, A statistical theory of the strength of materials, Proceedings of the Royal Swedish Academy of
    Engineering Sciences 151, 1939.
    """
    return VolumeModel("weibull", stress, exponent, 0.0, slope, 0.0, "Weibull 1939")


Model = VolumeModel | LaminaModel

#: The models with a capacity, which give a life in revolutions.
RATED = ("lundberg-palmgren", "iso-16281")

#: Functions that make each model, by its name.
MODELS: dict[str, Callable[..., Model]] = {
    "lundberg-palmgren": lundberg_palmgren,
    "ioannides-harris": ioannides_harris,
    "zaretsky": zaretsky,
    "weibull": weibull,
    "iso-16281": iso_16281,
}


def model(name: str, **parameters: Any) -> Model:
    """Return a model by name, with given parameters.

    Raises
    ------
    InputError
        If there is no such model, it has no such parameter, or a parameter is out of range.

    Examples
    --------
    >>> model("ioannides-harris", fatigue_limit=276.0).fatigue_limit
    276.0
    """
    if not isinstance(name, str) or name not in MODELS:
        raise InputError("model", name, "be a fatigue model", f"choose from {', '.join(MODELS)}")
    known = tuple(inspect.signature(MODELS[name]).parameters)
    for parameter, value in parameters.items():
        if parameter not in known:
            raise InputError(parameter, value, f"be a parameter of {name}", f"it has {', '.join(known)}")
    return MODELS[name](**parameters)
