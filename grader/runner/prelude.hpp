// Precompiled for every submission: the headers that nearly every part includes, and the instances
// of Eigen's templates that small programs need, so that not every part instantiates them again.
// Holds no line of the solution.
#pragma once

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <bounce/render.hpp>
#include <bounce/solve_lcp.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// Only for clang: g++ takes longer to read all instances than to make the few that a part needs.
#ifdef __clang__
namespace bounce::prelude {

// Never called; compiling these lines makes the instances. Reading one costs every part about 0.3
// ms, and making one costs a part about 15 ms. So an instance is here if at least one in sixty
// parts of the gallery uses it.
template <class To, class... Expressions>
void set(To&& to, const Expressions&... expressions) {
  ((to = expressions), ...);
}

inline void instances(Eigen::Matrix2d& A2, Eigen::Vector2d& a2, Eigen::Matrix3d& A, Vector3& a,
                      Eigen::Matrix4d& A4, Eigen::Vector4d& a4, Eigen::MatrixXd& Ax,
                      Eigen::VectorXd& ax, Jacobian& J, Trajectory& trajectory,
                      Eigen::Matrix<double, 2, 4>& corners) {
  double s = a.dot(A * a) + a.dot(a);
  set(A, A.transpose() * A * A * s, s * A);
  set(a, a - s * a, -a, A.col(0), A.inverse() * a, a + s * A.inverse() * a,
      A.partialPivLu().solve(a));
  a += A * a;
  a *= s;
  corners = A2 * corners;
  Eigen::Index at = 0;
  corners.row(1).minCoeff(&at);
  set(a2, s * a2);
  set(A4.block<3, 3>(0, 0), A * s);
  set(A4.topLeftCorner<3, 3>(), A.transpose() * A * A * s, s * A.transpose() * A * A);
  A4.col(3) << s, s, s, s;
  A4.block<3, 3>(0, 0) /= s;
  a = a4.head<3>();
  a = Vector3(A.diagonal().cwiseInverse());

  int i = 0;
  ax = Eigen::VectorXd::Zero(i);
  Ax(i, i) = ax(i);
  A4(i, i) = a(i) + a2(i) + J(i, i) + corners(i, i);
  J.col(0) = a;
  trajectory.q.col(0) = a;
  trajectory = {Eigen::Matrix3Xd(3, i), Eigen::Matrix3Xd(3, i)};
  set(trajectory.q, Eigen::Matrix3Xd::Zero(3, 3), Eigen::MatrixXd::Zero(3, 3));
}

// The arguments of a part are const, which needs other instances. The names mean nothing.
inline Vector3 instances(const Vector3& a, const Vector3& b, const Vector3& c, const Jacobian& J,
                         const Parameters& params, const Eigen::Matrix<double, 2, 4>& S,
                         const Eigen::Matrix2d& R, const Eigen::Matrix3d& A,
                         const Eigen::Matrix3d& B, const Eigen::Vector4d& h) {
  const double s = h(3);
  Eigen::Index at = 0;
  S.row(1).minCoeff(&at);
  const Eigen::Vector2d u = S.col(at);
  const Eigen::Vector2d w = a.head<2>() + R * u;
  const Vector3 d = J.col(0);
  Eigen::Matrix3d D;
  D << a, -b, b;
  D << J.col(1), -J.col(0), J.col(0);
  Jacobian K;
  K << a, b;
  set(D, A.transpose() * B * A * s, A * B, A * s);
  const Eigen::Matrix3d E = params.M(), F = A.inverse();
  Vector3 f = A * a + J.col(1) * h(0) - J.col(0) * h(1) + J.col(0) * h(2);
  f += J.col(1) * h(0) - J.col(0) * h(1) + J.col(0) * h(2);
  const Vector3 k = J.col(1) * h(0) + J.col(0) * h(1), j = J * u, z = Vector3::Zero();
  const Vector3 o = a + s * b + s * Vector3::UnitY();
  const Eigen::Vector2d n = J.transpose() * b;
  set(f, J.col(1) * h(0) - J.col(0) * h(1) + J.col(0) * h(2), c + a * h(0) - b * h(1) + b * h(2),
      a + s * A * b, a + s * (A * b), a + s * b + c, a + s * b, s * a + b, s * a);
  const double t = a.dot(b + s * c) + a.dot(b) + J.col(1).dot(b) + (1 + s) * a.dot(b) +
                   a.dot((1 + s) * b + s * A * c) + a.dot(b + s * A * c);
  Lcp lcp;
  lcp.V.topRightCorner<3, 1>() = a;
  lcp.V.row(3) << t, -1, -1, 0;
  lcp.p.setZero();
  lcp.V.setZero();
  return Vector3(1, 0, -u.y()) + Vector3(w.x(), w.y(), d.x() + E(0, 0) + F(0, 0));
}

}  // namespace bounce::prelude
#endif
