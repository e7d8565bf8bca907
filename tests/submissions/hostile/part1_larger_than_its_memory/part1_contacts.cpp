#include <bounce/part1_contacts.hpp>

namespace bounce {

char zeros[1500000000];
Contact get_contacts(const Vector3&, const Parameters& params) {
  return {Jacobian::Zero(), 1.0 * zeros[params.T]};
}

}  // namespace bounce
