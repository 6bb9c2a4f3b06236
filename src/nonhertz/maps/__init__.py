"""Maps: stand-ins for a contact, a microsecond a query, for programs that solve whole bearings.

`contact_map` makes a `ContactMap`. In Python it is evaluated by `ContactMap.at` and `ContactMap.under`; for compiled
code, `PRESSED`, `LOADED`, `PRESSURES` and `SHARE` are C functions that take its ``table``.
"""

from typing import TYPE_CHECKING

from nonhertz.lazy import attach

if TYPE_CHECKING:
    from nonhertz.maps.evaluation import LOADED as LOADED
    from nonhertz.maps.evaluation import PRESSED as PRESSED
    from nonhertz.maps.evaluation import PRESSURES as PRESSURES
    from nonhertz.maps.evaluation import SHARE as SHARE
    from nonhertz.maps.evaluation import State as State
    from nonhertz.maps.misses import SampledErrors as SampledErrors
    from nonhertz.maps.value import ContactMap as ContactMap
    from nonhertz.maps.value import MapPoint as MapPoint
    from nonhertz.maps.verb import contact_map as contact_map

__getattr__, __dir__ = attach(
    __name__,
    {
        "evaluation": ("LOADED", "PRESSED", "PRESSURES", "SHARE", "State"),
        "misses": ("SampledErrors",),
        "value": ("ContactMap", "MapPoint"),
        "verb": ("contact_map",),
    },
)
