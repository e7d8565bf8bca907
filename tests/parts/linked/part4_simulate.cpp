#include <bounce/part4_simulate.hpp>

#include "linked.hpp"

namespace bounce::tests {

[[maybe_unused]] const bool part4_is_linked = link_part('4', &Linked::simulate, &bounce::simulate);

}  // namespace bounce::tests
