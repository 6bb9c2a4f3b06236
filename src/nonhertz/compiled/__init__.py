"""Machine code for the numerical core: compiled by Numba, cached on disk, and the same wherever it comes from.

`entry` is the decorator of functions that Python calls, `compiled` that of the functions that these call. Machine code
is looked up by a digest of everything that it is made from: the function, all that it calls, the constants that it
reads, the compiler, its settings and the processor. Neither the time nor the name of a source file matters, so machine
code of other sources is never found.
"""

from nonhertz.compiled.decorator import compiled as compiled
from nonhertz.compiled.entries import entry as entry
