// What each room of the core shows to Python.
#pragma once

#include <nanobind/nanobind.h>

namespace nonhertz {

void bind_strips(nanobind::module_& m);
void bind_harmonic_elements(nanobind::module_& m);
void bind_strip_parts(nanobind::module_& m);
void bind_bodies(nanobind::module_& m);
void bind_reliefs(nanobind::module_& m);
void bind_grids(nanobind::module_& m);
void bind_judging(nanobind::module_& m);
void bind_solve(nanobind::module_& m);
void bind_bearing(nanobind::module_& m);
void bind_maps(nanobind::module_& m);
void bind_subsurface(nanobind::module_& m);

}  // namespace nonhertz
