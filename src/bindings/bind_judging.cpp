#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"

namespace nonhertz {

void bind_judging(nb::module_&) {}

}  // namespace nonhertz
