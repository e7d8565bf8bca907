#include <bounce/part1_contacts.hpp>
#include "words.hpp"

namespace bounce {

Contact get_contacts(const Vector3&, const Parameters&) {
  return {Jacobian::Zero(), 0.0};
}

}  // namespace bounce
