#include <bounce/part1_contacts.hpp>

#include "linked.hpp"

namespace bounce::tests {

[[maybe_unused]] const bool part1_is_linked =
    link_part('1', &Linked::get_contacts, &bounce::get_contacts);

}  // namespace bounce::tests
