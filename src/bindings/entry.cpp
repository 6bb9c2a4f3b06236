// What Python calls when it loads the module: the bindings only run on a processor that has their instructions.
#include <Python.h>

#include "processor.hpp"

#if defined(_WIN32)
#define VISIBLE extern "C" __declspec(dllexport)
#else
#define VISIBLE extern "C" __attribute__((visibility("default")))
#endif
#define JOINED(a, b) a##b
#define NAME_OF_ENTRY(module) JOINED(PyInit_, module)

extern "C" PyObject* PyInit_bound(void);

VISIBLE PyObject* NAME_OF_ENTRY(NONHERTZ_MODULE)(void);
VISIBLE PyObject* NAME_OF_ENTRY(NONHERTZ_MODULE)(void) {
#if defined(NONHERTZ_V3)
  if (!nonhertz::knows_v3()) {
    PyErr_SetString(PyExc_ImportError, "built for processors of x86-64-v3, which have AVX2 and FMA; this one has not");
    return nullptr;
  }
#endif
  return PyInit_bound();
}
