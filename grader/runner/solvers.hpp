// Precompiled on top of the prelude, for the few parts whose text mentions a decomposition or a
// matrix of dynamic size. Their instances take seconds to make, and too long to read for parts that
// don't need them. Holds no line of the solution.
#pragma once

#include "prelude.hpp"

#ifdef __clang__
namespace bounce::prelude {

template <class Solver, class Matrix, class Vector>
void solved_with(const Solver& solver, Matrix& A, Vector& a, const Vector& b, double s) {
  a = solver.solve(b);
  a = solver.solve(b + b);
  a = b + s * solver.solve(b);
  a = b + s * solver.solve(b + b);
  A = solver.solve(A);
  A = A.transpose() * solver.solve(A) * s;
}

inline void solvers(Eigen::Matrix3d& A3, Eigen::Vector3d& a3, Eigen::MatrixXd& A,
                    Eigen::VectorXd& a, Eigen::Matrix2d& A2, const Eigen::MatrixXd& B,
                    const Eigen::VectorXd& b, const Jacobian& J, double s) {
  solved_with(A3.llt(), A3, a3, a3, s);
  solved_with(A3.ldlt(), A3, a3, a3, s);
  solved_with(A3.partialPivLu(), A3, a3, a3, s);
  solved_with(A3.fullPivLu(), A3, a3, a3, s);
  solved_with(A3.colPivHouseholderQr(), A3, a3, a3, s);
  solved_with(B.partialPivLu(), A, a, b, s);
  solved_with(B.fullPivLu(), A, a, b, s);
  A = A.transpose() * B * A * s;
  A = B * A;
  A = s * B;
  int i = 0;
  Eigen::Index at = 0;
  A = Eigen::MatrixXd(i, i);
  A = Eigen::MatrixXd::Zero(i, i);
  a = Eigen::VectorXd::Zero(i);
  A = A3;
  a = a3;
  A2 = A;
  A3 = A;
  a3 = a;
  A << s, s, s, s;
  a << s, s, s;
  A << J.col(1), -J.col(0), J.col(0);
  A(i, i) = a(i) + B(i, i) + b(i);
  A.col(i) += a3.head(2);
  A.row(i) << s, s, s, s;
  A.row(1).minCoeff(&at);
  A.topLeftCorner(3, 3) = A;
  A.block(0, 0, 3, 3) = A3;
  a = a + A * b;
}

}  // namespace bounce::prelude
#endif
