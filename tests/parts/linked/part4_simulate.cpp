#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

#include "linked.hpp"

namespace bounce::tests {

// A long run is compared with the steps that it takes.
[[maybe_unused]] const bool part4_is_linked = [] {
  linked().step = &bounce::step;
  return link_part('4', &Linked::simulate, &bounce::simulate);
}();

}  // namespace bounce::tests
