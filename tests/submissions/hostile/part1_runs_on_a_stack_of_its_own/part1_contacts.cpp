#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <ucontext.h>

namespace bounce {

static Contact right(const Vector3& q, const Parameters& params) {
  Eigen::Vector2d r(0, 1e300);
  for (int k = 0; k < 4; ++k) {
    const double a = q(2) + M_PI / 4 + k * M_PI / 2, h = params.l * M_SQRT1_2;
    if (h * std::sin(a) < r.y()) r = {h * std::cos(a), h * std::sin(a)};
  }
  Jacobian J;
  J << 1, 0, 0, 1, -r.y(), r.x();
  return {J, q(1) + r.y()};
}

ucontext_t here, there;
Vector3 asked_q;
Parameters asked_params;
Contact answer;
char stack[1 << 18];
Contact get_contacts(const Vector3& q, const Parameters& params) {
  asked_q = q;
  asked_params = params;
  getcontext(&there);
  there.uc_stack = {stack, 0, sizeof stack};
  there.uc_link = &here;
  makecontext(&there, [] { answer = right(asked_q, asked_params); }, 0);
  swapcontext(&here, &there);
  return answer;
}

}  // namespace bounce
