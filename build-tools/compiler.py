"""The C++ compiler that the core is built with: the machine's, or Zig's, which the index has for most systems.

Run by itself it prints what must be installed to have one: nothing, as a rule.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

# What the core asks for beyond old C++20: vectors, which MSVC does not have, and threads, which libc++ has from 18 on.
PROBE = """
#define _LIBCPP_ENABLE_EXPERIMENTAL
#include <numbers>
#include <span>
#include <stop_token>
#include <thread>
#if defined(__clang__) ? __clang_major__ < 14 : !defined(__GNUC__) || __GNUC__ < 11
#error "too old"
#endif
using Pack [[gnu::vector_size(32)]] = double;
std::jthread thread;
"""
NONE = "nonhertz: no C++20 compiler (g++ 11, clang 14 or newer) was found"


def of_the_machine() -> str | None:
    """Return a compiler that is there: what CXX names, whatever it is, or one that knows C++20."""
    if os.environ.get("CXX") or os.name == "nt":  # on Windows Visual Studio's clang, as pyproject.toml asks
        return os.environ.get("CXX", "clang-cl")
    command = ("-std=c++20", "-fsyntax-only", "-x", "c++", "-")
    for name in filter(shutil.which, ("c++", "g++", "clang++")):
        if not subprocess.run([name, *command], input=PROBE, text=True, capture_output=True, check=False).returncode:
            return name
    return None


def needed() -> list[str]:
    """Return what must be installed to have a compiler, and say why."""
    if of_the_machine():
        return []
    print(f"{NONE}: ziglang, which brings one, is taken from the index.", file=sys.stderr, flush=True)
    return ["ziglang>=0.14"]


def choose(folder: Path) -> None:
    """Name the compiler for CMake, which calls each tool by one word: Zig's are scripts in a folder."""
    if name := of_the_machine():
        os.environ["CXX"] = name
        return
    try:
        import ziglang
    except ImportError:
        sys.exit(f"{NONE}: install one, or ziglang, which brings one: pip install ziglang")
    zig = Path(ziglang.__file__).with_name("zig")
    folder.mkdir(parents=True, exist_ok=True)
    for variable, tool in {"CXX": "c++", "AR": "ar", "RANLIB": "ranlib"}.items():
        script = folder / tool
        script.write_text(f'#!/bin/sh\nexec "{zig}" {tool} "$@"\n', encoding="utf-8")
        script.chmod(0o755)
        os.environ[variable] = str(script.absolute())


if __name__ == "__main__":
    print(*needed())
