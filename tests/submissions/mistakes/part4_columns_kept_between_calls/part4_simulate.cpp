#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

#include <vector>

namespace bounce {

std::vector<Vector3> allQ;
std::vector<Vector3> allV;

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  allQ.push_back(q_0);
  allV.push_back(v_0);
  for (int t = 1; t < params.T; ++t) {
    State next = step(allQ.back(), allV.back(), params);
    allQ.push_back(next.q);
    allV.push_back(next.v);
  }

  Trajectory trajectory;
  trajectory.q.resize(3, static_cast<Eigen::Index>(allQ.size()));
  trajectory.v.resize(3, static_cast<Eigen::Index>(allV.size()));
  for (std::size_t t = 0; t < allQ.size(); ++t) {
    trajectory.q.col(static_cast<Eigen::Index>(t)) = allQ[t];
    trajectory.v.col(static_cast<Eigen::Index>(t)) = allV[t];
  }
  return trajectory;
}

}  // namespace bounce
