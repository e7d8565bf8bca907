// The quantities that the four parts exchange. Each is declared once, with its shape, unit and
// sign. Equation numbers are those of the handout (README.md).
#pragma once

#include <Eigen/Dense>

namespace bounce {

// (x, y, theta) of anything: a configuration, a velocity, a force, a column of a Jacobian.
// x to the right, y up, theta counter-clockwise; the ground is y = 0.
using Vector3 = Eigen::Vector3d;

// [J_t J_n], 3x2, eq. (6): the tangential column first, then the normal one.
// J_t^T v and J_n^T v are the velocity of the touching corner along the ground and away from it.
using Jacobian = Eigen::Matrix<double, 3, 2>;

// Every number of the scene. The values are the assignment's; tests use others too.
struct Parameters {
  double l = 0.2;              // side of the square, m
  double m = 0.3;              // mass, kg
  double mu = 0.3;             // friction between square and ground, no unit
  double epsilon = 0.5;        // restitution, no unit: v_n after = -epsilon v_n before
  Vector3 g{0.0, -9.81, 0.0};  // gravity, an acceleration: m/s^2, m/s^2, and 0: it has no torque
  double dt = 0.01;            // time step, s
  double delta = 0.001;        // the corner is in contact when phi < delta, m
  int T = 150;                 // columns of a trajectory, the initial state included

  // The inertia M = diag(m, m, m l^2 / 6): kg, kg, kg m^2, eq. (1).
  Eigen::Matrix3d M() const { return Vector3(m, m, m * l * l / 6.0).asDiagonal(); }
};

// Part 1: how the lowest corner of the square is related to the ground.
struct Contact {
  Jacobian J;  // 3x2; rows x and y have no unit, row theta is in m
  double phi;  // height of the lowest corner, m; negative below the ground, eq. (4)
};

// Part 2: find z = (f_n, f_t1, f_t2, lambda), in N, N, N and m/s, with 0 <= V z + p perpendicular
// to z >= 0, eq. (8).
struct Lcp {
  Eigen::Matrix4d V;  // 4x4; the 3x3 block of the forces in s/kg, eq. (9)
  Eigen::Vector4d p;  // 4; the first three in m/s, the last in N, eq. (10)
};

// Part 3: where the square is and how it moves.
struct State {
  Vector3 q;  // (x, y, theta) of the centre: m, m, rad
  Vector3 v;  // (v_x, v_y, omega): m/s, m/s, rad/s
};

// Part 4: one state per column; column 0 is the initial state.
struct Trajectory {
  Eigen::Matrix3Xd q;  // 3xT: m, m, rad
  Eigen::Matrix3Xd v;  // 3xT: m/s, m/s, rad/s
};

}  // namespace bounce
