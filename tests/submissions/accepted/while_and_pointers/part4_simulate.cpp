#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <cstring>
#include <memory>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const auto numbers = static_cast<std::size_t>(3 * params.T);
  auto qs = std::make_unique<double[]>(numbers), vs = std::make_unique<double[]>(numbers);
  double *q = qs.get(), *v = vs.get(), *const end = q + numbers;
  std::memcpy(q, q_0.data(), 3 * sizeof(double));
  std::memcpy(v, v_0.data(), 3 * sizeof(double));
  while (q + 3 != end) {
    const State next = step(Eigen::Map<Vector3>(q), Eigen::Map<Vector3>(v), params);
    std::memcpy(q += 3, next.q.data(), 3 * sizeof(double));
    std::memcpy(v += 3, next.v.data(), 3 * sizeof(double));
  }
  return {Eigen::Map<Eigen::Matrix3Xd>(qs.get(), 3, params.T),
          Eigen::Map<Eigen::Matrix3Xd>(vs.get(), 3, params.T)};
}

}  // namespace bounce
