// What the module holds; entry.cpp is how Python gets there. No numbers are worked out in src/bindings.
#include "bindings/rooms.hpp"

NB_MODULE(bound, m) {
  using namespace nonhertz;
  // Whoever leaves Python with a contact in a global variable has done nothing wrong.
  nanobind::set_leak_warnings(false);
  m.doc() = "The numbers of nonhertz in C++: arrays in, arrays out.";
  // What is kept for the life of a process, such as elements and free faces, is no leak.
  nanobind::set_leak_warnings(false);
  bind_strips(m);
  bind_harmonic_elements(m);
  bind_strip_parts(m);
  bind_bodies(m);
  bind_grids(m);
  bind_judging(m);
  bind_solve(m);
  bind_bearing(m);
  bind_maps(m);
  bind_subsurface(m);
}
