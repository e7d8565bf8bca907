// Precompiled for every submission: what nearly each part includes, and the instances of Eigen's
// templates that small programs are made of, so that they aren't made anew for every part.
// No line of the solution.
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
#include <functional>
#include <iostream>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

// g++ reads instances back more slowly than it makes the few that a part needs.
#ifdef __clang__
namespace bounce::prelude {

// Never called: that these lines compile makes the instances.
template <class Matrix, class Vector>
void square_of(Matrix& A, Matrix& B, Vector& a, double s) {
  A = B.transpose() * A * B;
  A = B.transpose() * A * B * s;
  A = B.transpose() * (A * B);
  A = B.transpose() * (A * B) * s;
  A = A * B;
  A = A * B * s;
  A = s * A * B;
  A = s * A;
  A = A * s;
  A = A + B;
  A = A.transpose().eval();
  a = A * a;
  a = s * A * a;
  a = A * (a + s * a);
  a = a + s * A * a;
  a = a + s * (A * a);
  a = a + s * a;
  a = a - s * a;
  a += s * a;
  a += A * a;
  a *= s;
  a = -a;
  s = a.dot(A * a);
  s = a.dot(a);
  s = a.transpose() * A * a;
  s = a.transpose() * a;
  s = a.norm() + a.sum() + a.maxCoeff() + A.sum();
  A.setZero();
  A.setIdentity();
  a.setZero();
  A(0, 0) = a(0);
  A.row(0) = a.transpose();
  A.col(0) = a;
  A.col(0) = -a;
  A.col(0) = B.col(0);
  A.col(0) = -B.col(0);
  a = A.col(0);
  a = -A.col(0);
  a = A.row(0).transpose();
  A = a.asDiagonal();
  A = a.asDiagonal() * B;
}

inline void instances(Eigen::Matrix2d& A2, Eigen::Vector2d& a2, Eigen::Matrix3d& A3,
                      Eigen::Vector3d& a3, Eigen::Matrix4d& A4, Eigen::Vector4d& a4,
                      Eigen::MatrixXd& A, Eigen::VectorXd& a, Jacobian& J, Contact& contact,
                      Trajectory& trajectory, Eigen::Matrix<double, 2, 4>& corners) {
  const double s = a3(0);
  square_of(A3, A3, a3, s);

  A2 << s, -s, s, s;
  A3 << s, s, s, s, s, s, s, s, s;
  A3 << a3, -a3, a3;
  A3 << J.col(1), -J.col(0), J.col(0);
  A4 << s, s, s, s, s, s, s, s, s, s, s, s, s, s, s, s;
  a2 << s, s;
  a3 << s, s, s;
  a4 << s, s, s, s;
  a4 << a3, s;
  J << s, s, s, s, s, s;
  J << a3, a3;
  corners << s, s, s, s, s, s, s, s;
  corners = A2 * corners;
  Eigen::Index at = 0;
  a2 = corners.col(at);
  corners.row(1).minCoeff(&at);
  corners.col(0) = A2 * a2;

  A2 = Eigen::Rotation2Dd(s).toRotationMatrix();
  a2 = Eigen::Rotation2Dd(s) * a2;
  A2 = A2.inverse();
  A3 = A3.inverse().eval();
  A4 = A4.inverse().eval();
  a3 = A3.inverse() * a3;
  a3 = a3 + s * A3.inverse() * a3;
  a3 = a3 + s * (A3.inverse() * a3);
  A4.block<3, 3>(0, 0) = A3;
  A4.block<3, 3>(0, 0) = A3 * s;
  A4.block<3, 3>(0, 0) = A3.transpose() * A3 * A3 * s;
  A4.block<3, 1>(0, 3) = a3;
  A4.block<1, 3>(3, 0) = a3.transpose();
  A4.topLeftCorner<3, 3>() = A3;
  A4.topLeftCorner<3, 3>() = A3.transpose() * A3 * A3 * s;
  A4.topRightCorner<3, 1>() = a3;
  A4.row(3) << s, s, s, s;
  A4.col(3) << s, s, s, s;
  a4.head<3>() = a3;
  a4.head(3) = a3;
  a3 = a4.head<3>();

  J.col(0) = a3;
  J.col(0) << s, s, s;
  contact.J.col(1) << s, s, s;
  a3 = J.col(0);
  a3 = J * a2;
  a2 = J.transpose() * a3;
  A2 = J.transpose() * A3 * J;
  a3 = J.col(1) * s - J.col(0) * s + J.col(0) * s;
  a3 += A3 * (a3 + J.col(1) * s - J.col(0) * s + J.col(0) * s);
  a4(0) = J.col(1).dot(a3) + J.col(1).transpose() * a3;
  trajectory.q.resize(3, 3);
  trajectory.q.col(0) = a3;
  a3 = trajectory.q.col(0);
  trajectory.q = Eigen::Matrix3Xd::Zero(3, 3);
  trajectory.q = Eigen::MatrixXd::Zero(3, 3);
  std::cout << A3 << a3.transpose() << a3 << A4 << a4 << J << A << s << std::endl;
  std::vector<double> numbers(4, s);
  std::min_element(numbers.begin(), numbers.end());
  std::sort(numbers.begin(), numbers.end());
  numbers.push_back(s);
  std::vector<Eigen::Vector2d> points{a2};
  points.push_back(a2);
}

}  // namespace bounce::prelude
#endif
