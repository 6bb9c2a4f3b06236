#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"

namespace nonhertz {

void bind_grids(nb::module_&) {}

}  // namespace nonhertz
