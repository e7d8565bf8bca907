#include <bounce/part1_contacts.hpp>
#include <exception>
#include <unistd.h>

namespace bounce {

struct Odd : std::exception {
  const char* what() const noexcept override {
    for (;;) pause();
  }
};
Contact get_contacts(const Vector3&, const Parameters&) { throw Odd(); }

}  // namespace bounce
