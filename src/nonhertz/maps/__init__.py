"""Maps: stand-ins for a contact, a microsecond a query, for programs that solve whole bearings.

`contact_map` makes a `ContactMap`. In Python it is evaluated by `ContactMap.at` and
`ContactMap.under`; in functions compiled by Numba, `pressed`, `loaded`, `pressures` and `share` take its ``tables``.
"""

from nonhertz.maps.evaluation import State as State
from nonhertz.maps.evaluation import Tables as Tables
from nonhertz.maps.evaluation import loaded as loaded
from nonhertz.maps.evaluation import pressed as pressed
from nonhertz.maps.evaluation import pressures as pressures
from nonhertz.maps.evaluation import share as share
from nonhertz.maps.misses import SampledErrors as SampledErrors
from nonhertz.maps.value import ContactMap as ContactMap
from nonhertz.maps.value import MapPoint as MapPoint
from nonhertz.maps.verb import contact_map as contact_map
