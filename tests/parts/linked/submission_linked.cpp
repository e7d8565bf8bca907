// The submission is linked into the test program. The judge has another one of this file, which
// asks a runner in another process (grader/judge/submission_remote.cpp).
#include "../submission.hpp"
#include "linked.hpp"
#include "thrown.hpp"

namespace bounce {

tests::Linked& tests::linked() {
  static Linked functions;
  return functions;
}

namespace submission {

using tests::linked;
using tests::naming_the_part;

Contact get_contacts(const Vector3& q, const Parameters& params) {
  return naming_the_part("part 1", [&] { return linked().get_contacts(q, params); });
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  return naming_the_part("part 2", [&] { return linked().form_lcp(J, v, params); });
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  return naming_the_part("part 3, or what it calls,", [&] { return linked().step(q, v, params); });
}

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const Trajectory got = naming_the_part("part 4, or what it calls,",
                                         [&] { return linked().simulate(q_0, v_0, params); });
  require_columns(got.q.cols(), got.v.cols(), params.T);
  return got;
}

Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const Trajectory got = linked().simulate(q_0, v_0, params);
  const Eigen::Index columns = columns_at_hand(got.q.cols(), got.v.cols(), params.T);
  return {got.q.leftCols(columns), got.v.leftCols(columns)};
}

}  // namespace submission
}  // namespace bounce
