#include <bounce/part1_contacts.hpp>
#include <csignal>

namespace bounce {

Contact get_contacts(const Vector3&, const Parameters&) {
  std::raise(SIGKILL);
  return {Jacobian::Zero(), 0.0};
}

}  // namespace bounce
