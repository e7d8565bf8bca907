#include <bounce/part2_lcp.hpp>
using namespace std;
using namespace Eigen;

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Matrix3d J_hat, M = params.M(), M_inv = M.inverse();
  J_hat << J.col(1), -J.col(0), J.col(0);

  Matrix4d V = Matrix4d::Zero();
  V.block<3, 3>(0, 0) = J_hat.transpose() * M_inv * J_hat * params.dt;
  V.block<2, 1>(1, 3) = Vector2d::Ones();
  V.row(3) = RowVector4d(params.mu, -1, -1, 0);

  Vector3d dv = params.dt * M_inv * M * params.g;
  Vector4d p(J.col(1).dot((1 + params.epsilon) * v + dv), -J.col(0).dot(v + dv), J.col(0).dot(v + dv), 0);
  return {V, p};
}

}
