"""REXS, the exchange format of gear units and their bearings (rexs.info): bearings from and to it, as XML and JSON."""

from nonhertz.files.rexs.reading import bearing_file_of_rexs as bearing_file_of_rexs
from nonhertz.files.rexs.reading import read_rexs as read_rexs
from nonhertz.files.rexs.writing import to_rexs as to_rexs
from nonhertz.files.rexs.writing import write_rexs as write_rexs
