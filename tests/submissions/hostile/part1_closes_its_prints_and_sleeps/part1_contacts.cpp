#include <bounce/part1_contacts.hpp>
#include <cstdio>
#include <ctime>

namespace bounce {
Contact get_contacts(const Vector3&, const Parameters&) {
  std::fclose(stdout);
  std::fclose(stderr);
  const timespec long_time{1000000, 0};
  nanosleep(&long_time, nullptr);
  return {Jacobian::Zero(), 0.0};
}
}  // namespace bounce
