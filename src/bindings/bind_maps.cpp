#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"

namespace nonhertz {

void bind_maps(nb::module_&) {}

}  // namespace nonhertz
