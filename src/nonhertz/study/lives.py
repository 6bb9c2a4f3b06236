"""Lives as measures with a gradient."""

from __future__ import annotations

from nonhertz.errors import InputError
from nonhertz.life.catalogue import Model, VolumeModel
from nonhertz.life.lamina import EXPONENT, LaminaModel
from nonhertz.result.measures import PowerIntegral


def damage(model: Model) -> PowerIntegral:
    """Return the damage of a contact under a load, up to a factor that does not depend on shapes.

    The life is proportional to the damage to the power ``-1 / model.slope``: if the damage grows by one per cent, the
    life falls by ``1 / model.slope`` per cent.

    Parameters
    ----------
    model : VolumeModel or LaminaModel
        A model of `nonhertz.life` without a fatigue limit.

    Returns
    -------
    PowerIntegral
        The integral of p^k b^(1 - h) for a volume model, since the stress is proportional to the pressure p and the
        depth to the half-width b; that of (p b)^4.5 for laminae, without a function of edge stress.

    Raises
    ------
    InputError
        If it is not such a model, or has a fatigue limit.

    Examples
    --------
    >>> import nonhertz as nh
    >>> damage(nh.life.lundberg_palmgren())
    PowerIntegral(pressure_power=10.333333333333334, half_width_power=-1.3333333333333335)
    """
    if isinstance(model, LaminaModel):
        return PowerIntegral(EXPONENT, EXPONENT)
    if not isinstance(model, VolumeModel):
        raise InputError("model", model, "be a fatigue model", "make one, such as nonhertz.life.lundberg_palmgren()")
    if model.fatigue_limit > 0.0:
        remedy = "use a model without a limit, such as nonhertz.life.lundberg_palmgren()"
        raise InputError("model.fatigue_limit", model.fatigue_limit, "be zero", remedy)
    return PowerIntegral(model.exponent, 1.0 - model.depth_exponent)
