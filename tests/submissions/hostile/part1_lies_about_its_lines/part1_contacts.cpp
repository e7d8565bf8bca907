#line 7 "/etc/shadow"
#error root:x:0:0
#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3&, const Parameters&) {
  return {Jacobian::Zero(), 0.0};
}

}  // namespace bounce
