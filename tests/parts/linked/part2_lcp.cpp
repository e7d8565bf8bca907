#include <bounce/part2_lcp.hpp>

#include "linked.hpp"

namespace bounce::tests {

[[maybe_unused]] const bool part2_is_linked = link_part('2', &Linked::form_lcp, &bounce::form_lcp);

}  // namespace bounce::tests
