"""Files as measuring machines write them, of positions in mm and heights in um."""

import io
from collections.abc import Sequence
from typing import Any

import numpy as np
import x3pio


def lines(pairs: Sequence[tuple[float, float]], form: str, head: str = "", end: str = "\n") -> bytes:
    return (head + end.join(form.format(y, z) for y, z in pairs) + end).encode()


def heights_alone(um: np.ndarray, head: str = "", form: str = "{:.6f}", end: str = "\n") -> bytes:
    return (head + end.join(map(form.format, um.tolist())) + end).encode()


def smd(um: np.ndarray, step: float, count: int = 0, heights: str | None = None, kind: str = "I") -> bytes:
    count, heights = count or len(um), "\r\n".join(str(z) for z in um) if heights is None else heights
    head = f"ISO 5436-2:2012\0roller\0\r\nPRF\0 1 ISO5436\0\r\nCX\0 {kind}\0 {count} mm\0 1.0e0 D\0 {step:.5e} \r\n"
    head += f"CZ\0 A\0 {count} um\0 1.0e0 D\0\r\n\x03\r\nDATE: 01-May-2024\0\r\nCOMMENT /* no */\0\r\n\x03\r\n"
    return (head + heights + "\r\n\x03\r\n12345\r\n\x03\r\n\x1a").encode("latin-1")


def prf(um: np.ndarray, step: float, count: int = 0, spacing: str | None = None) -> bytes:
    count, spacing = count or len(um), f"SPACING CX {step:.6e}\r\n" if spacing is None else spacing
    head = f"1 2\r\nSG2004 0.0e+000 PRF\r\nCX M {count}.0e+000 MM 1.000000e+000 D\r\n"
    head += f"CZ M {count}.0e+000 MM 1.000000e-009 L\r\nEOR\r\nSTYLUS_RADIUS 0.0 MM\r\n{spacing}EOR\r\n"
    return (head + "\r\n".join(f"{1e6 * z:.0f}" for z in um) + "\r\nEOR\r\nEOF\r\n").encode()


def marwin(pairs: Sequence[tuple[float, float]], count: int = 0, along: str = "{0:.9f} 0.0 {1:.9f}") -> bytes:
    rows = [f"{k}=" + along.format(y, 1e-3 * z) + " 0.000000000 0" for k, (y, z) in enumerate(pairs)]
    head = f"[PROFILE_HEADER]\nNAME=a\nNO_POINTS={count or len(pairs)}\n[PROFILE_HISTORY]\nProductName=e\n"
    return (head + "[PROFILE_VALUES]\n// X,Y,Z,C,Lock\n" + "\n".join(rows) + "\n").encode()


def x3p(um: np.ndarray, step: float, **saved: Any) -> bytes:
    stream = io.BytesIO()
    x3pio.Profile.from_array(1e-6 * um, x_scale=1e-3 * step).save(stream, **saved)
    return stream.getvalue()
