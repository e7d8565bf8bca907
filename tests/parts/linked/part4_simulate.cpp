// Calls part 4 of a submission that is linked into the test program.
#include <bounce/part4_simulate.hpp>

#include "../submission.hpp"
#include "thrown.hpp"

namespace bounce::submission {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const Trajectory got = tests::naming_the_part("part 4, or what it calls,",
                                                [&] { return bounce::simulate(q_0, v_0, params); });
  require_columns(got.q.cols(), got.v.cols(), params.T);
  return got;
}

Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const Trajectory got = bounce::simulate(q_0, v_0, params);
  const Eigen::Index columns = columns_at_hand(got.q.cols(), got.v.cols(), params.T);
  return {got.q.leftCols(columns), got.v.leftCols(columns)};
}

}  // namespace bounce::submission
