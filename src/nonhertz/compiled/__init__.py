"""Machine code for the numerical core: made by Numba, kept on disk, and the same wherever it comes from.

`compiled` is the decorator. Machine code is looked for under a digest of everything that it is made from: the function,
all that it calls, the constants that it reads, the compiler, its settings and the processor. No file's time is asked
for, nor its name, so that what does not belong to the code that runs is never found.
"""

from nonhertz.compiled.decorator import compiled as compiled
