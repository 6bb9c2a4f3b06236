#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"

namespace nonhertz {

void bind_subsurface(nb::module_&) {}

}  // namespace nonhertz
