#include <bounce/part1_contacts.hpp>
#include <exception>

namespace bounce {

struct Odd : std::exception {
  const char* what() const noexcept override { throw 1; }
};

Contact get_contacts(const Vector3&, const Parameters&) { throw Odd(); }

}  // namespace bounce
