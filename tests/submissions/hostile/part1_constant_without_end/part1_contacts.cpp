#include <bounce/part1_contacts.hpp>

namespace bounce {
constexpr long count() {
  long n = 0;
  while (n >= 0) n = (n + 1) % 1000;
  return n;
}
constexpr long counted = count();
Contact get_contacts(const Vector3&, const Parameters&) {
  return {Jacobian::Constant(counted), 0.0};
}
}  // namespace bounce
