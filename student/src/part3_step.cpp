#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  // TODO: test for contact (eq. 11), then step freely (eq. 12) or with contact (eqs. 13 and 14).
  static_cast<void>(q);
  static_cast<void>(v);
  static_cast<void>(params);
  return {Vector3::Zero(), Vector3::Zero()};
}

}  // namespace bounce
