#include "assignment_batch.hpp"

#include <cmath>

#include "assignment_fast.hpp"

namespace bounce::methods {
namespace {

// One number of all squares each.
struct Columns {
  double *x, *y, *theta, *v_x, *v_y, *omega, *cosine, *sine;
};

// One step of n squares, right for those that turn by no more than kLargestTurn; returns how many
// turn by more.
[[gnu::always_inline]] inline long step_all(const StepConstants& k, std::size_t n,
                                            const Columns& columns) {
  double *const x = columns.x, *const y = columns.y, *const theta = columns.theta;
  double *const v_x = columns.v_x, *const v_y = columns.v_y, *const omega = columns.omega;
  double *const cosine = columns.cosine, *const sine = columns.sine;
  const double half = k.half, per_gyration = 1 / k.gyration, mu = k.mu;
  const double bounce = 1 + k.epsilon, dt = k.dt, delta = k.delta, dv_x = k.dv_x, dv_y = k.dv_y;
#pragma omp simd  // the columns don't overlap
  for (std::size_t i = 0; i < n; ++i) {
    const double c = cosine[i], s = sine[i];
    const double r_y = -half * (std::abs(c) + std::abs(s));
    const double r_x = half * (std::copysign(1.0, c) * s - std::copysign(1.0, s) * c);
    const bool touches = y[i] + r_y < delta;  // eq. (11)

    const double u_n = bounce * (v_y[i] + r_x * omega[i]) + dv_y;
    const double u_t = v_x[i] - r_y * omega[i] + dv_x;
    const double a = 1 + r_x * r_x * per_gyration, b = -r_x * r_y * per_gyration;
    const double c_t = 1 + r_y * r_y * per_gyration;
    const double N = b * u_t - c_t * u_n, T = b * u_n - a * u_t;
    const bool sticks = std::abs(T) <= mu * N;
    const double friction = -std::copysign(mu, -T);  // p_t / p_n while it slides
    const double divisor = sticks ? a * c_t - b * b : a + friction * b;
    const double pressed = touches ? (u_n < 0 ? 1.0 : 0.0) : 0.0;
    const double quotient = pressed / divisor;
    const double p_n = (sticks ? N : -u_n) * quotient;
    const double p_t = sticks ? T * quotient : friction * p_n;

    v_x[i] += dv_x + p_t;
    v_y[i] += dv_y + p_n;
    omega[i] += (r_x * p_n - r_y * p_t) * per_gyration;
    const double turned = dt * omega[i];
    x[i] += dt * v_x[i];
    y[i] += dt * v_y[i] + (touches ? delta : 0.0);
    theta[i] += turned;

    const Turn by = small_turn(turned);
    cosine[i] = c * by.cosine - s * by.sine;
    sine[i] = s * by.cosine + c * by.sine;
  }
  long large = 0;
#pragma omp simd reduction(+ : large)
  for (std::size_t i = 0; i < n; ++i) large += std::abs(dt * omega[i]) <= kLargestTurn ? 0 : 1;
  return large;
}

// Where the compiler can be told to use wider vectors for one function, there is a version for
// processors that have them, and the choice is made when the program runs.
#if defined(__GNUC__) && defined(__x86_64__)
__attribute__((target("avx2,fma"))) long step_wide(const StepConstants& k, std::size_t n,
                                                   const Columns& columns) {
  return step_all(k, n, columns);
}
bool has_wide_vectors() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#else
long step_wide(const StepConstants& k, std::size_t n, const Columns& columns) {
  return step_all(k, n, columns);
}
bool has_wide_vectors() { return true; }
#endif

long step_usual(const StepConstants& k, std::size_t n, const Columns& columns) {
  return step_all(k, n, columns);
}

}  // namespace

AssignmentBatch::AssignmentBatch(const Parameters& params,
                                 const std::vector<Motion<double>>& starts)
    : k_(params), cosine_(starts.size()), sine_(starts.size()) {
  for (const Motion<double>& s : starts) {
    x_.push_back(s.x);
    y_.push_back(s.y);
    theta_.push_back(s.theta);
    v_x_.push_back(s.v_x);
    v_y_.push_back(s.v_y);
    omega_.push_back(s.omega);
  }
}

void AssignmentBatch::take_anew(std::size_t i) {
  cosine_[i] = std::cos(theta_[i]);
  sine_[i] = std::sin(theta_[i]);
}

void AssignmentBatch::steps(long n) {
  for (; n > 0; --n) step();
}

void AssignmentBatch::step() {
  if (fresh_-- == 0) {
    for (std::size_t i = 0; i < size(); ++i) take_anew(i);
    fresh_ = 256;
  }
  static const auto step_them = has_wide_vectors() ? step_wide : step_usual;
  const Columns columns{x_.data(),   y_.data(),     theta_.data(),  v_x_.data(),
                        v_y_.data(), omega_.data(), cosine_.data(), sine_.data()};
  if (step_them(k_, size(), columns) == 0) return;
  for (std::size_t i = 0; i < size(); ++i)
    if (!(std::abs(k_.dt * omega_[i]) <= kLargestTurn)) take_anew(i);
}

Motion<double> AssignmentBatch::motion(std::size_t i) const {
  return {x_[i], y_[i], theta_[i], v_x_[i], v_y_[i], omega_[i]};
}

}  // namespace bounce::methods
