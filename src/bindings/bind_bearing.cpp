#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"

namespace nonhertz {

void bind_bearing(nb::module_&) {}

}  // namespace nonhertz
