// Contacts of a square with the ground, drawn at random, and the LCP of each: V and p are formed
// here entry by entry, from eqs. (9) and (10).
#pragma once

#include <bounce/solve_lcp.hpp>

#include <cmath>
#include <random>

namespace bounce::tests {

using Eigen::Matrix4d;
using Eigen::Vector4d;

class Random {
 public:
  explicit Random(unsigned long long seed) : engine_(seed) {}
  bool one_in(unsigned n) { return engine_() % n == 0; }
  int integer(int a, int b) { return std::uniform_int_distribution<int>(a, b)(engine_); }
  double uniform(double a, double b) { return std::uniform_real_distribution<>(a, b)(engine_); }
  double logarithmic(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
  Matrix4d matrix() {
    return Matrix4d::NullaryExpr([this] { return uniform(-1.0, 1.0); });
  }
  Vector4d vector() {
    return Vector4d::NullaryExpr([this] { return uniform(-1.0, 1.0); });
  }

 private:
  std::mt19937_64 engine_;
};

struct Scene {
  double r_x, r_y;  // from the centre to the lowest corner, m
  Vector3 v;
  Parameters params;
};

Scene any_scene(Random& random);

// Masses from 1e-9 kg to 1e9 kg, and dt / m down to 1e-12 s/kg or less.
Scene extreme_scene(Random& random);

// The numbers that V and p are made of, with J_t = (1, 0, -r_y) and J_n = (0, 1, r_x), eq. (6).
struct Numbers {
  double a, b, c;   // dt J_n^T M^-1 J_n, dt J_n^T M^-1 J_t, dt J_t^T M^-1 J_t, s/kg
  double u_n, u_t;  // p(0), and the tangential velocity without contact, m/s
  double mu;
};

Numbers numbers(const Scene& scene);

Lcp form(const Numbers& n);

}  // namespace bounce::tests
