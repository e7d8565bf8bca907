#include <bounce/part1_contacts.hpp>
#include <cstdio>
#include <ctime>

namespace bounce {
Contact get_contacts(const Vector3&, const Parameters&) {
  for (;;) {
    std::puts("still here");
    std::fflush(stdout);
    const timespec a_while{0, 30000000};
    nanosleep(&a_while, nullptr);
  }
}
}  // namespace bounce
