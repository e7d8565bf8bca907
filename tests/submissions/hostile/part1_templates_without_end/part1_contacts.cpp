#include <bounce/part1_contacts.hpp>

namespace bounce {
template <int n>
struct Tower {
  static constexpr long value = Tower<n + 1>::value + Tower<n + 2>::value;
};
Contact get_contacts(const Vector3&, const Parameters&) {
  return {Jacobian::Zero(), 1.0 * Tower<0>::value};
}
}  // namespace bounce
