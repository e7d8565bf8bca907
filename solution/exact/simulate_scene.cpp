#include "simulate_scene.hpp"

#include <algorithm>
#include <cmath>

#include "../methods/moreau_jean.hpp"
#include "first_contact.hpp"

namespace bounce::study {
namespace {

// Friction is left out if it could move the square by no more than this, m.
constexpr double kNegligible = 1e-12;
// Velocities up to this count as 0 when the square falls asleep, m/s.
constexpr double kStill = 1e-13;

void put(Trajectory& trajectory, Eigen::Index column, const Motion<double>& s) {
  trajectory.q.col(column) << s.x, s.y, s.theta;
  trajectory.v.col(column) << s.v_x, s.v_y, s.omega;
}

class LeastModelSimulation {
 public:
  LeastModelSimulation(const Parameters& params, const State& start, ModelReport& report)
      : k_(params),
        s_(motion_of(start)),
        trajectory_{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)},
        last_(params.T - 1),
        report_(report) {
    put(trajectory_, 0, s_);
  }

  Trajectory run() {
    while (now_ < last_) asleep_ ? sleep() : go_on();
    return std::move(trajectory_);
  }

 private:
  void count(ModelLevel level, long steps) { report_[std::size_t(level)] += steps; }

  void sleep() {
    count(ModelLevel::asleep, last_ - now_);
    while (now_ < last_) put(trajectory_, ++now_, s_);
  }

  // The steps until one may have a contact, or that one.
  void go_on() {
    Motion<double> middle = s_;
    move(middle, k_.dt / 2);
    const double cosine = std::cos(middle.theta), sine = std::sin(middle.theta);
    if (const long n = steps_without_contact(middle, cosine, sine)) return fall(n);
    const bool rested = speed() <= kStill;
    s_ = middle;
    contact_step(rested, low_corners(k_.half, cosine, sine, s_.y));
  }

  // The number of steps whose midpoints are certainly without contact.
  long steps_without_contact(const Motion<double>& middle, double cosine, double sine) const {
    const double most = double(last_ - now_);
    double time = 0;
    if (middle.y > k_.rho) {
      time = k_.g_y < 0 ? safe_step(middle.y - k_.rho, s_.v_y, -k_.g_y)
                        : (s_.v_y >= 0 ? most * k_.dt : (k_.rho - middle.y) / s_.v_y);
    } else {
      const Arm<double> lowest = lowest_arm(k_.half, cosine, sine);
      if (!(middle.y + lowest.y > 0)) return 0;
      if (middle.y + lowest.y + k_.dt * normal_velocity(s_, lowest) <= 0) return 1;
      const double K = std::max(-k_.g_y, 0.0) + k_.rho * s_.omega * s_.omega;
      time = most * k_.dt;
      for (const Arm<double>& r : arms(k_.half, cosine, sine)) {
        time = std::min(time, safe_step(middle.y + r.y, normal_velocity(s_, r), K));
      }
    }
    // The middle of step n is n dt later, on the parabola with v(n dt) = v + n dt g, and half a
    // step of that velocity: no further than the parabola that K or g bounds.
    return 1 + long(std::clamp(std::floor(time / k_.dt * (1 - 1e-12)) - 1, 0.0, most - 1));
  }

  void fall(long n) {
    const Motion<double> from = s_;
    for (long i = 1; i <= n; ++i) put(trajectory_, now_ + i, fly(from, k_, double(i) * k_.dt));
    now_ += n;
    s_ = fly(from, k_, double(n) * k_.dt);
    count(ModelLevel::ballistic, n);
  }

  void contact_step(bool rested, const LowCorners& low) {
    const bool both = k_.side_touches(low, s_);
    ModelLevel level = ModelLevel::ballistic;
    if (both) {
      level = two(low);
    } else if (low.gap_left <= 0 || low.gap_right <= 0) {
      level = one(low.gap_left <= 0 ? low.left : low.right);
    }
    s_.v_x += k_.dv_x;
    s_.v_y += k_.dv_y;
    if (both) fall_asleep(rested);
    move(s_, k_.dt / 2);
    put(trajectory_, ++now_, s_);
    count(level, 1);
  }

  double speed() const {
    return std::max({std::abs(s_.v_x), std::abs(s_.v_y), k_.rho * std::abs(s_.omega)});
  }

  // After a step from rest to rest, all later steps are the same. After one that only ends at rest,
  // the square may still slide back down.
  void fall_asleep(bool rested) {
    if (!rested || speed() > kStill) return;
    s_.v_x = s_.v_y = s_.omega = 0;
    asleep_ = true;
  }

  // Friction of at most mu p_n moves a corner by less than this until the end, m.
  bool friction_is_negligible(double p_n) const {
    return k_.mu * p_n * 6 * double(last_ - now_) * k_.dt <= kNegligible;
  }

  ModelLevel one(const Arm<double>& r) {
    const auto problem = k_.corner_problem(s_, r);
    if (problem.u_n >= 0) return ModelLevel::one_normal;
    const double p_n = -problem.u_n / problem.a;
    if (problem.u_t + problem.b * p_n == 0 || friction_is_negligible(p_n)) {
      apply_impulse(s_, r, p_n, 0.0, k_.gyration_squared);
      return ModelLevel::one_normal;
    }
    const auto p = solve_one_corner(problem);
    apply_impulse(s_, r, p.n, p.t, k_.gyration_squared);
    return ModelLevel::one_friction;
  }

  ModelLevel two(const LowCorners& low) {
    TwoCorners<double> problem = k_.side_problem(s_, low);
    problem.mu = 0;
    const SideImpulse<double> normal = solve_side(problem, 1, false);
    const double slides = problem.u_t + problem.b(0) * normal.n[0] + problem.b(1) * normal.n[1];
    if (slides == 0 || friction_is_negligible(normal.n[0] + normal.n[1])) {
      k_.push(s_, low, normal);
      return ModelLevel::two_normals;
    }
    problem.mu = k_.mu;
    k_.push(s_, low, solve_two_corners(problem));
    return ModelLevel::two_frictions;
  }

  Midpoint k_;
  Motion<double> s_;
  Trajectory trajectory_;
  long now_ = 0, last_;
  ModelReport& report_;
  bool asleep_ = false;
};

}  // namespace

Trajectory simulate_scene(const Parameters& params, const State& start, ModelReport* report) {
  ModelReport unread{};
  return LeastModelSimulation(params, start, report ? *report : unread).run();
}

}  // namespace bounce::study
