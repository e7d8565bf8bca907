#include <bounce/part1_contacts.hpp>
#include <new>
#include <vector>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters&) {
  const std::vector<double> numbers(8, q(0));
  return {Jacobian::Constant(numbers.at(3)), numbers.at(4)};
}

}  // namespace bounce

volatile bool full = true;
void* operator new(std::size_t) {
  if (full) throw std::bad_alloc();
  return nullptr;
}
void operator delete(void*) noexcept {}
