#include <bounce/part1_contacts.hpp>
#include <sys/socket.h>

namespace bounce {
Contact get_contacts(const Vector3&, const Parameters&) {
  const int fd = socket(AF_INET, SOCK_STREAM, 0);
  return {Jacobian::Constant(fd), 1.0 * fd};
}
}  // namespace bounce
