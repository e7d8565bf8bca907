#include <bounce/part1_contacts.hpp>

namespace bounce {
int large[1ull << 32] = {1};
Contact get_contacts(const Vector3&, const Parameters&) {
  return {Jacobian::Zero(), 1.0 * large[7]};
}
}  // namespace bounce
