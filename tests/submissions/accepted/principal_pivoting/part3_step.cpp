#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <Eigen/LU>

namespace bounce {
namespace {

// Murty's method: exchanges the first pair of an unknown and its slack of which the one that isn't 0
// is negative.
Vector3 forces(Lcp lcp) {
  const double size = lcp.V(0, 0);
  lcp.V.topLeftCorner<3, 3>() /= size;  // so that all entries are of the size of mu and 1
  bool basic[4] = {};
  for (int pivots = 0; pivots < 1000; ++pivots) {
    Eigen::Matrix4d B = Eigen::Matrix4d::Identity();
    for (int i = 0; i < 4; ++i)
      if (basic[i]) B.col(i) = -lcp.V.col(i);
    const Eigen::Vector4d x = B.partialPivLu().solve(lcp.p);
    const double least = -1e-13 * lcp.p.cwiseAbs().maxCoeff();
    int wrong = 0;
    while (wrong < 4 && x(wrong) >= least) ++wrong;
    if (wrong == 4) {
      Vector3 f;
      for (int i = 0; i < 3; ++i) f(i) = basic[i] ? x(i) / size : 0;
      return f;
    }
    basic[wrong] = !basic[wrong];
  }
  return Vector3::Zero();
}

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const auto contact = get_contacts(q, params);
  const bool touches = contact.phi < params.delta;
  Vector3 v_next = v + params.dt * params.g;
  if (touches) {
    const Vector3 f = forces(form_lcp(contact.J, v, params));
    v_next += params.dt * params.M().inverse() *
              (contact.J.col(1) * f(0) + contact.J.col(0) * (f(2) - f(1)));
  }
  return {q + params.dt * v_next + Vector3(0, touches ? params.delta : 0, 0), v_next};
}

}  // namespace bounce
