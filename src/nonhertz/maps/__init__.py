"""Maps: fast surrogates of a contact, a microsecond per query, for programs that solve whole bearings.

`contact_map` makes a `ContactMap`. In Python it is evaluated by `ContactMap.at` and `ContactMap.under`; for compiled
code, `AT_APPROACH`, `AT_LOAD`, `MAXIMA` and `STRIP_LOADS` are C functions that take its ``table``.
"""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.maps.evaluation import AT_APPROACH as AT_APPROACH
    from nonhertz.maps.evaluation import AT_LOAD as AT_LOAD
    from nonhertz.maps.evaluation import MAXIMA as MAXIMA
    from nonhertz.maps.evaluation import STRIP_LOADS as STRIP_LOADS
    from nonhertz.maps.evaluation import State as State
    from nonhertz.maps.misses import SampledErrors as SampledErrors
    from nonhertz.maps.value import ContactMap as ContactMap
    from nonhertz.maps.value import MapPoint as MapPoint
    from nonhertz.maps.verb import contact_map as contact_map

__getattr__, __dir__ = attach(
    __name__,
    {
        "evaluation": ("AT_LOAD", "AT_APPROACH", "MAXIMA", "STRIP_LOADS", "State"),
        "misses": ("SampledErrors",),
        "value": ("ContactMap", "MapPoint"),
        "verb": ("contact_map",),
    },
)
