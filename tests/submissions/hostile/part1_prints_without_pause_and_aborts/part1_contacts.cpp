#include <bounce/part1_contacts.hpp>
#include <unistd.h>

#include <cstdlib>
#include <ctime>

static void attack() {
  for (int i = 0; i < 800; ++i) {
    const timespec millisecond{0, 1000000};
    if (write(1, "x", 1) == 1) nanosleep(&millisecond, nullptr);
  }
  std::abort();
}

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters&) {
  attack();
  return {Jacobian::Constant(q(0)), 0};
}

}  // namespace bounce
