#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"

namespace nonhertz {

void bind_strips(nb::module_&) {}

}  // namespace nonhertz
