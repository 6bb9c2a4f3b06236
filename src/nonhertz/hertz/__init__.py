"""Hertz's closed forms: the point contact, the line contact, and the compression in a line contact.

The rest of the package is checked against these, so they are accurate to the last digits for every shape, from the
circle to a contact a million times longer than wide.
"""

from nonhertz.hertz.line import (
    LineContact,
    half_space_line_compression,
    line_contact,
    plane_strain_cylinder_compression,
)
from nonhertz.hertz.point import PointContact, point_contact
from nonhertz.lazy import dir_of

__all__ = [
    "LineContact",
    "PointContact",
    "half_space_line_compression",
    "line_contact",
    "plane_strain_cylinder_compression",
    "point_contact",
]
__dir__ = dir_of(__name__)
