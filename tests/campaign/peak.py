"""The most memory that a process has had."""

from pathlib import Path


def peak_memory() -> float:
    """Return the largest resident memory of this process [MB].

    Not `resource.getrusage`, which counts the memory of the process that started this one too.
    """
    lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    return next(float(line.split()[1]) for line in lines if line.startswith("VmHWM:")) / 1024.0
