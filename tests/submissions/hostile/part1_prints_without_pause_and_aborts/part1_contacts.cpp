#include <bounce/part1_contacts.hpp>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <ctime>

static void attack() {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < std::chrono::seconds(2)) {
    const timespec nap{0, 10000000};
    if (write(1, "x", 1) == 1) nanosleep(&nap, nullptr);
  }
  std::abort();
}

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters&) {
  attack();
  return {Jacobian::Constant(q(0)), 0};
}

}  // namespace bounce
