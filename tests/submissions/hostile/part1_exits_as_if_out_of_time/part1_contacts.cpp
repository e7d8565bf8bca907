#include <bounce/part1_contacts.hpp>
#include <csignal>
#include <unistd.h>

namespace bounce {

Contact get_contacts(const Vector3&, const Parameters&) {
  _exit(128 + SIGXCPU);
}

}  // namespace bounce
