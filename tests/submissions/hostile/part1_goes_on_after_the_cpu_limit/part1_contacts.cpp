#include <bounce/part1_contacts.hpp>
#include <csignal>
#include <unistd.h>

namespace bounce {

volatile bool forever = true;
Contact get_contacts(const Vector3&, const Parameters&) {
  std::signal(SIGXCPU, [](int) { (void)!write(1, "go on\n", 6); });
  while (forever) {
  }
  return {Jacobian::Zero(), 0.0};
}

}  // namespace bounce
