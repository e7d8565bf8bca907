#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <algorithm>
#include <limits>
#include <vector>

namespace bounce {

namespace {

// Own LCP solver: tries all 16 ways to choose which of z_i and w_i is zero, and keeps the one
// that breaks the signs the least.
Vector3 solve_by_enumeration(const Lcp& lcp) {
  // forces in units in which all entries are of the size of a velocity
  const double unit = lcp.V(0, 0);
  Eigen::Matrix4d V = lcp.V;
  V.topLeftCorner<3, 3>() /= unit;

  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int mask = 0; mask < 16; ++mask) {
    std::vector<int> basic;
    for (int i = 0; i < 4; ++i) {
      if (mask & (1 << i)) basic.push_back(i);
    }
    Eigen::Vector4d z = Eigen::Vector4d::Zero();
    if (!basic.empty()) {
      const Eigen::MatrixXd A = V(basic, basic);
      const Eigen::VectorXd b = -lcp.p(basic);
      const Eigen::FullPivLU<Eigen::MatrixXd> lu(A);
      if (!lu.isInvertible()) continue;
      z(basic) = lu.solve(b);
    }
    const Eigen::Vector4d w = V * z + lcp.p;
    double violation = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4; ++i) {
      violation = std::max(violation, mask & (1 << i) ? -z(i) : -w(i));
    }
    if (violation < least) {
      least = violation;
      best = z;
    }
  }
  return best.head<3>() / unit;
}

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Eigen::Matrix3d Minv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;

  if (contact.phi >= params.delta) {
    const Vector3 v1 = v + params.dt * Minv * f_e;
    return {q + params.dt * v1, v1};
  }

  Eigen::Matrix<double, 2, 3> D;
  D << 0, -1, 1,
       1, 0, 0;
  const Vector3 f_c = contact.J * D * solve_by_enumeration(form_lcp(contact.J, v, params));
  const Vector3 v1 = v + params.dt * Minv * (f_e + f_c);
  const Vector3 q1 = q + params.dt * v1 + Vector3(0, params.delta, 0);
  return {q1, v1};
}

}  // namespace bounce
