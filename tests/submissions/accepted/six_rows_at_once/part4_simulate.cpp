#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

using Six = Eigen::Matrix<double, 6, 1>;

// q above v, in one vector.
Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const auto f = [&params](const Six& x) {
    const State s = step(x.head<3>(), x.tail<3>(), params);
    return (Six() << s.q, s.v).finished();
  };

  Eigen::Matrix<double, 6, Eigen::Dynamic> X(6, params.T);
  X.col(0) << q_0, v_0;
  for (Eigen::Index t = 1; t < X.cols(); ++t) X.col(t) = f(X.col(t - 1));
  return {X.topRows<3>(), X.bottomRows<3>()};
}

}  // namespace bounce
