"""Drawings of whole bearings: functions (solution, ax) -> ax, and finished sheets."""
