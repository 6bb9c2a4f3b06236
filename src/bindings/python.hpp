// Included before all else into nanobind and the bindings: nanobind prints, and trusts Python.h to bring what that
// takes, which it does not in the stable interface. Python.h itself wants to be the first.
#pragma once

#include <Python.h>

#include <cstdio>
