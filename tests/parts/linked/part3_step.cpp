#include <bounce/part3_step.hpp>

#include "linked.hpp"

namespace bounce::tests {

[[maybe_unused]] const bool part3_is_linked = link_part('3', &Linked::step, &bounce::step);

}  // namespace bounce::tests
