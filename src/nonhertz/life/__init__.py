"""Rolling-contact fatigue life from the stress below a solved contact.

`assess` returns the life of a body by several models, relative to the same bodies under an ideal pressure and, where a
standard gives a capacity, in revolutions; `solve_spectrum` solves a contact under a list of loads for it. Models are
made by name with `model`, or by their functions: `lundberg_palmgren`, `ioannides_harris`, `zaretsky`, `weibull` and
`iso_16281`.
"""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.life.assessment import Life as Life
    from nonhertz.life.assessment import assess as assess
    from nonhertz.life.capacity import Raceway as Raceway
    from nonhertz.life.capacity import raceway as raceway
    from nonhertz.life.catalogue import MODELS as MODELS
    from nonhertz.life.catalogue import RATED as RATED
    from nonhertz.life.catalogue import Model as Model
    from nonhertz.life.catalogue import VolumeModel as VolumeModel
    from nonhertz.life.catalogue import ioannides_harris as ioannides_harris
    from nonhertz.life.catalogue import lundberg_palmgren as lundberg_palmgren
    from nonhertz.life.catalogue import model as model
    from nonhertz.life.catalogue import weibull as weibull
    from nonhertz.life.catalogue import zaretsky as zaretsky
    from nonhertz.life.lamina import LaminaModel as LaminaModel
    from nonhertz.life.lamina import iso_16281 as iso_16281
    from nonhertz.life.overrolling import Overrolled as Overrolled
    from nonhertz.life.overrolling import overrolled as overrolled
    from nonhertz.life.spectrum import ContactLoadCase as ContactLoadCase
    from nonhertz.life.spectrum import solve_spectrum as solve_spectrum
    from nonhertz.life.volume import Exposure as Exposure
    from nonhertz.life.volume import exposure as exposure

__getattr__, __dir__ = attach(
    __name__,
    {
        "assessment": ("Life", "assess"),
        "capacity": ("Raceway", "raceway"),
        "catalogue": (
            "MODELS",
            "RATED",
            "Model",
            "VolumeModel",
            "ioannides_harris",
            "lundberg_palmgren",
            "model",
            "weibull",
            "zaretsky",
        ),
        "lamina": ("LaminaModel", "iso_16281"),
        "overrolling": ("Overrolled", "overrolled"),
        "spectrum": ("ContactLoadCase", "solve_spectrum"),
        "volume": ("Exposure", "exposure"),
    },
)
