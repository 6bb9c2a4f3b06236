"""Effect of oil, contamination and reliability on the life of a bearing, ISO 281.

    a_ISO = 0.1 [1 - (1.5859 - k1 / kappa^k2) (e_C C_u / P)^0.4]^(-9.185), at most 50,

with (k1, k2) = (1.3993, 0.054381) for 0.1 <= kappa < 0.4, (1.2348, 0.19087) for kappa < 1 and (1.2348, 0.071739) up to
4, for radial roller bearings. kappa is the viscosity over nu_1, 45000 n^(-0.83) D_pw^(-1/2) below n = 1000/min and
4500 n^(-1/2) D_pw^(-1/2) above. The contamination factor is

    e_C = min(c_1 kappa^0.68 D_pw^0.55, 1) (1 - c_2 / D_pw^(1/3))

and for other reliabilities than 90 %, a_1 = 0.95 (ln(1/R) / ln(1/0.9))^(2/3) + 0.05, within 0.005 of the standard's
table. Between two temperatures, lg lg(nu + 0.7) is linear in the logarithm of the absolute temperature (Walther; ASTM
D341), which holds above 2 mm^2/s.

The standards are quoted from public programs that agree with each other; their text was not available. For the classes
of cleanliness, c_1 and c_2 of ``"high"`` are in two programs, which do not agree on its name (one calls it -/15/12 in
an oil bath), and those of circulating oil in one, as they had been recalled before. Others were not found twice.
"""

from __future__ import annotations

import math

from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, numbers, one_of, positive

MOST_FACTOR = 50.0
LEAST_RATIO, MOST_RATIO = 0.1, 4.0
_BY_RATIO = ((0.4, 1.3993, 0.054381), (1.0, 1.2348, 0.19087), (math.inf, 1.2348, 0.071739))
#: c_1 and c_2 of e_C, by the class of cleanliness.
CLEANLINESS = {
    "high": (0.0864, 0.6796),
    "-/15/12": (0.0432, 0.9987),
    "-/17/14": (0.0288, 1.6329),
    "-/19/16": (0.0216, 2.3362),
}
#: The least e_C of the levels in the guide of ISO 281, for pitch diameters below 100 mm and above.
GUIDE = {"normal": (0.5, 0.6), "slight": (0.3, 0.4), "typical": (0.1, 0.2), "severe": (0.0, 0.0)}
_ABSOLUTE = 273.15
_THINNEST = 2.0  # mm^2/s


def reference_viscosity(speed: float, pitch_diameter: float) -> float:
    """Return nu_1 [mm^2/s], the viscosity at which the surfaces just separate.

    Parameters
    ----------
    speed : float
        Speed [1/min].
    pitch_diameter : float
        Pitch diameter [mm].

    Examples
    --------
    >>> round(reference_viscosity(1500, 51.56), 2)
    16.18
    """
    positive("speed", speed, "give the speed in 1/min")
    positive("pitch_diameter", pitch_diameter, "give the pitch diameter in mm")
    by_speed = 45000.0 * speed**-0.83 if speed < 1000.0 else 4500.0 / math.sqrt(speed)
    return float(by_speed / math.sqrt(pitch_diameter))


def oil_viscosity(
    temperature: float, *, viscosities: tuple[float, float], temperatures: tuple[float, float] = (40.0, 100.0)
) -> float:
    """Return the viscosity of an oil [mm^2/s] at a temperature, from its viscosities at two others.

    Parameters
    ----------
    temperature : float
        Temperature of the oil in the bearing [degC].
    viscosities : tuple of float
        Viscosities at the two other temperatures [mm^2/s], above 2: ISO VG 220 has 220 at 40 degC.
    temperatures : tuple of float
        The two other temperatures [degC].

    Raises
    ------
    InputError
        If an argument is out of range, or the viscosity falls below 2 mm^2/s, where the equation does not hold.

    References
    ----------
    The Walther equation with 0.7 of ASTM D341, as two public programs have it.

    Examples
    --------
    >>> round(oil_viscosity(68, viscosities=(220, 18.09)), 2)
    54.26
    """
    remedy = "give it in degC: 40 and 100 are usual"
    for name, value in (("temperature", temperature), *(("temperatures", celsius) for celsius in _two(temperatures))):
        finite(name, value, remedy)
        if value <= -_ABSOLUTE:
            raise InputError(name, value, f"lie above {-_ABSOLUTE:g} degC", remedy)
    (first, second), (thick, thin) = sorted(_two(temperatures)), _two(viscosities, "viscosities")
    if _two(temperatures)[0] > _two(temperatures)[1]:
        thick, thin = thin, thick
    if first == second:
        raise InputError("temperatures", temperatures, "differ", "give those at which the viscosities were measured")
    if not thick > thin > _THINNEST:
        condition = f"exceed {_THINNEST:g} mm2/s and be lower at the higher temperature"
        raise InputError("viscosities", viscosities, condition, "give them in the order of the temperatures")
    ends = [math.log(_ABSOLUTE + celsius) for celsius in (first, second)]
    slope = (_twice(thin) - _twice(thick)) / (ends[1] - ends[0])
    exponent = _twice(thick) + slope * (math.log(_ABSOLUTE + temperature) - ends[0])
    viscosity = 10.0 ** min(10.0**exponent, 300.0) - 0.7
    if not _THINNEST < viscosity < 1e12:
        condition = f"leave the oil with more than {_THINNEST:g} mm2/s, where the equation holds, and fluid"
        raise InputError("temperature", temperature, condition, "give another temperature, or measure the viscosity")
    return float(viscosity)


def _two(values: object, name: str = "temperatures") -> tuple[float, float]:
    remedy = "give two, such as (40, 100)"
    pair = numbers(name, values, remedy)  # type: ignore[arg-type]
    if pair.shape != (2,):
        raise InputError(name, values, "be two numbers", remedy)
    return float(pair[0]), float(pair[1])


def _twice(viscosity: float) -> float:
    return math.log10(math.log10(viscosity + 0.7))


def life_factor(viscosity_ratio: float, relative_limit: float) -> float:
    """Return a_ISO [-] of a radial roller bearing.

    Parameters
    ----------
    viscosity_ratio : float
        kappa, at least 0.1; values above 4 count as 4.
    relative_limit : float
        e_C C_u / P.

    Examples
    --------
    >>> round(life_factor(1.0, 0.5), 3)
    1.714
    """
    positive("viscosity_ratio", viscosity_ratio, "give the viscosity over the reference viscosity")
    positive("relative_limit", relative_limit, "give e_C C_u / P")
    if viscosity_ratio < LEAST_RATIO:
        condition = f"be at least {LEAST_RATIO:g}, below which ISO 281 gives no factor"
        raise InputError(
            "viscosity_ratio", viscosity_ratio, condition, "use a thicker oil, or leave out the lubrication"
        )
    kappa = min(viscosity_ratio, MOST_RATIO)
    k1, k2 = next((k1, k2) for below, k1, k2 in _BY_RATIO if kappa < below)
    reduced = 1.0 - (1.5859 - k1 / kappa**k2) * relative_limit**0.4
    return MOST_FACTOR if reduced <= 0.0 else min(MOST_FACTOR, 0.1 * reduced**-9.185)


def reliability_factor(reliability: float) -> float:
    """Return a_1 [-] for a reliability from 0.9 to 0.9995.

    Examples
    --------
    >>> reliability_factor(0.9), round(reliability_factor(0.99), 3)
    (1.0, 0.248)
    """
    positive("reliability", reliability, "give 0.9, or more")
    if not 0.9 <= reliability <= 0.9995:
        raise InputError("reliability", reliability, "lie between 0.9 and 0.9995", "give 0.95 for 95 %")
    return float(0.95 * (math.log(1.0 / reliability) / math.log(1.0 / 0.9)) ** (2.0 / 3.0) + 0.05)


def contamination_factor(viscosity_ratio: float, pitch_diameter: float, cleanliness: str) -> float:
    """Return e_C [-] for a class of cleanliness; not below 0.

    Parameters
    ----------
    viscosity_ratio : float
        kappa.
    pitch_diameter : float
        Pitch diameter [mm].
    cleanliness : {"high", "-/15/12", "-/17/14", "-/19/16", "normal", "slight", "typical", "severe"}
        ``"high"``: oil through a very fine filter, or bearings greased for life in a clean room and sealed; 0.6 to 0.8
        for pitch diameters below 100 mm. Otherwise circulating oil whose filter keeps it to this code of ISO 4406, or a
        level of the guide, for which the lower end of its range is used.

    Notes
    -----
    Guide values of ISO 281 (three programs and manuals agree), for pitch diameters below 100 mm and above: normal
    cleanliness 0.5 to 0.6 and 0.6 to 0.8, slight contamination 0.3 to 0.5 and 0.4 to 0.6, typical contamination 0.1
    to 0.3 and 0.2 to 0.4, severe contamination 0 to 0.1.

    Examples
    --------
    >>> round(contamination_factor(3.413, 51.56, "high"), 4), round(contamination_factor(3.413, 51.56, "-/17/14"), 3)
    (0.8174, 0.326)
    """
    positive("viscosity_ratio", viscosity_ratio, "give the viscosity over the reference viscosity")
    positive("pitch_diameter", pitch_diameter, "give the pitch diameter in mm")
    one_of("cleanliness", cleanliness, (*CLEANLINESS, *GUIDE), "choose one, or give e_C as a number")
    if cleanliness in GUIDE:
        return GUIDE[cleanliness][pitch_diameter >= 100.0]
    c1, c2 = CLEANLINESS[cleanliness]
    by_film = min(c1 * min(viscosity_ratio, MOST_RATIO) ** 0.68 * pitch_diameter**0.55, 1.0)
    return float(by_film * max(0.0, 1.0 - c2 / pitch_diameter ** (1.0 / 3.0)))
