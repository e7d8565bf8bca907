#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <ctime>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory all{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  State now{q_0, v_0};
  for (int t = 0; t < params.T; ++t) {
    if (t > 0) now = step(now.q, now.v, params);
    all.q.col(t) = now.q;
    all.v.col(t) = now.v;
  }
  return all;
}

}  // namespace bounce

extern "C" int clock_gettime(clockid_t, timespec* now) noexcept {
  *now = {0, 0};
  return 0;
}
extern "C" time_t time(time_t*) noexcept { return 0; }
