#include "simulate_scene.hpp"

#include <algorithm>
#include <cmath>

#include "../methods/impact_laws.hpp"
#include "../methods/moreau_jean.hpp"
#include "first_root.hpp"

namespace bounce::exact {
namespace {

using methods::Arm;
using methods::LowCorners;
using methods::Motion;
using methods::SideImpulse;
using methods::StepConstants;
using methods::TwoCorners;

// Friction is left out if it could move the square by no more than this, m.
constexpr double kNegligible = 1e-12;
// Velocities up to this count as 0 when the square falls asleep, m/s.
constexpr double kStill = 1e-13;

void put(Trajectory& trajectory, Eigen::Index column, const Motion<double>& s) {
  trajectory.q.col(column) << s.x, s.y, s.theta;
  trajectory.v.col(column) << s.v_x, s.v_y, s.omega;
}

Trajectory empty_trajectory(const Parameters& params, const State& start) {
  check(params, start);
  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  trajectory.q.col(0) = start.q;
  trajectory.v.col(0) = start.v;
  return trajectory;
}

struct Angle {
  double theta, cosine, sine;
};

class LeastModelSimulation {
 public:
  LeastModelSimulation(const Parameters& params, const State& start, ModelReport& report)
      : k_(params),
        g_x_(params.g.x()),
        g_y_(params.g.y()),
        s_(methods::motion_of<double>(start)),
        trajectory_(empty_trajectory(params, start)),
        last_(params.T - 1),
        report_(report) {}

  Trajectory run() {
    while (now_ < last_) {
      if (asleep_) {
        sleep();
      } else if (!fall()) {
        contact_step();
      }
    }
    return std::move(trajectory_);
  }

 private:
  void count(ModelLevel level, long steps) {
    report_.steps[std::size_t(level)] += steps;
    report_.seconds[std::size_t(level)] += double(steps) * k_.dt;
  }

  void sleep() {
    count(ModelLevel::asleep, last_ - now_);
    while (now_ < last_) put(trajectory_, ++now_, s_);
  }

  // cos and sin of an angle, kept for as long as it stays: a square that slides or rests does not
  // turn.
  const Angle& angle(double theta) {
    if (theta != angle_.theta) angle_ = {theta, std::cos(theta), std::sin(theta)};
    return angle_;
  }

  // The number of steps whose midpoints are certainly without contact.
  long steps_without_contact() {
    const double most = double(last_ - now_);
    Motion<double> middle = s_;
    methods::half_step(middle, k_);
    double time = 0;
    if (middle.y > k_.rho) {
      time = g_y_ < 0 ? safe_step(middle.y - k_.rho, s_.v_y, -g_y_)
                      : (s_.v_y >= 0 ? most * k_.dt : (k_.rho - middle.y) / s_.v_y);
    } else {
      const Angle& at = angle(middle.theta);
      const Arm<double> lowest = methods::lowest_arm(k_.half, at.cosine, at.sine);
      if (!(middle.y + lowest.y > 0)) return 0;
      if (middle.y + lowest.y + k_.dt * methods::normal_velocity(s_, lowest) <= 0) return 1;
      const double K = std::max(-g_y_, 0.0) + k_.rho * s_.omega * s_.omega;
      time = most * k_.dt;
      for (const Arm<double>& r : methods::arms(k_.half, at.cosine, at.sine)) {
        time = std::min(time, safe_step(middle.y + r.y, methods::normal_velocity(s_, r), K));
      }
    }
    // The middle of step n is n dt later, on the parabola with v(n dt) = v + n dt g, and half a
    // step of that velocity: no further than the parabola that K or g bounds.
    return 1 + long(std::clamp(std::floor(time / k_.dt * (1 - 1e-12)) - 1, 0.0, most - 1));
  }

  bool fall() {
    const long n = steps_without_contact();
    if (n == 0) return false;
    double* q = trajectory_.q.data() + 3 * now_;
    double* v = trajectory_.v.data() + 3 * now_;
    const Motion<double> from = s_;
    const double half_x = g_x_ / 2, half_y = g_y_ / 2, dt = k_.dt;
    for (long i = 1; i <= n; ++i) {  // no column depends on the one before
      const double t = double(i) * dt;
      q[3 * i] = from.x + t * (from.v_x + half_x * t);
      q[3 * i + 1] = from.y + t * (from.v_y + half_y * t);
      q[3 * i + 2] = from.theta + t * from.omega;
      v[3 * i] = from.v_x + g_x_ * t;
      v[3 * i + 1] = from.v_y + g_y_ * t;
      v[3 * i + 2] = from.omega;
    }
    now_ += n;
    s_ = {q[3 * n], q[3 * n + 1], q[3 * n + 2], v[3 * n], v[3 * n + 1], v[3 * n + 2]};
    count(ModelLevel::ballistic, n);
    return true;
  }

  void contact_step() {
    const bool rested = speed() <= kStill;
    methods::half_step(s_, k_);
    const Angle& at = angle(s_.theta);
    const LowCorners low = methods::low_corners(k_.half, at.cosine, at.sine, s_.y);
    const bool both = methods::side_touches(low, s_, k_);
    ModelLevel level = ModelLevel::ballistic;
    if (both) {
      level = two(low);
    } else if (low.gap_left <= 0 || low.gap_right <= 0) {
      level = one(low.gap_left <= 0 ? low.left : low.right);
    }
    s_.v_x += k_.dv_x;
    s_.v_y += k_.dv_y;
    if (both) fall_asleep(rested);
    methods::half_step(s_, k_);
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
    const auto problem = methods::corner_problem(s_, r, k_);
    if (problem.u_n >= 0) return ModelLevel::one_normal;
    warn(problem);
    const double p_n = -problem.u_n / problem.a;
    if (problem.u_t + problem.b * p_n == 0 || friction_is_negligible(p_n)) {
      methods::apply_impulse(s_, r, p_n, 0.0, k_.gyration_squared);
      return ModelLevel::one_normal;
    }
    ++report_.raised;
    const auto p = methods::solve_one_corner(problem);
    methods::apply_impulse(s_, r, p.n, p.t, k_.gyration_squared);
    return ModelLevel::one_friction;
  }

  ModelLevel two(const LowCorners& low) {
    TwoCorners<double> problem = methods::side_problem(s_, low, k_);
    if (slides_on_ && k_.mu < 4.0 / 3) {  // as it did a step ago; below 4/3 no other solution
      const auto p = methods::solve_side(problem, problem.u_t > 0 ? 1 : -1, true);
      if (p.violation <= 0) {
        methods::push_side(s_, low, p, k_);
        return ModelLevel::two_frictions;
      }
    }
    problem.mu = 0;
    const SideImpulse<double> normal = methods::solve_side(problem, 1, false);
    const double slides = problem.u_t + problem.b(0) * normal.n[0] + problem.b(1) * normal.n[1];
    if (slides == 0 || friction_is_negligible(normal.n[0] + normal.n[1])) {
      methods::push_side(s_, low, normal, k_);
      slides_on_ = false;
      return ModelLevel::two_normals;
    }
    ++report_.raised;
    problem.mu = k_.mu;
    methods::push_side(s_, low, methods::solve_two_corners(problem), k_);
    slides_on_ = true;
    return ModelLevel::two_frictions;
  }

  void warn(const methods::OneCorner<double>& k) {
    if (k_.mu == 0 || (several_ && gains_)) return;
    if (k.a <= k_.mu * std::abs(k.b))
      warn_once(several_, "a <= mu |b|: the contact problem may have several solutions");
    const double v_n = k.u_n - k_.dv_y;
    if (v_n < 0 && (1 - k_.epsilon * k_.epsilon) * k.a * k.c < k.b * k.b) {
      warn_once(gains_,
                "epsilon > sqrt(1 - b^2 / (a c)): Newton's law may gain energy; Poisson's and "
                "Stronge's do not");
    }
  }

  void warn_once(bool& warned, const std::string& text) {
    if (warned) return;
    warned = true;
    report_.warnings.push_back("from t = " + std::to_string(double(now_) * k_.dt) + " s: " + text);
  }

  StepConstants k_;
  double g_x_, g_y_;
  Motion<double> s_;
  Trajectory trajectory_;
  long now_ = 0, last_;
  ModelReport& report_;
  Angle angle_{0, 1, 0};
  bool asleep_ = false, slides_on_ = false, several_ = false, gains_ = false;
};

// One step of the whole model: always the LCP of two corners with friction. A corner that doesn't
// touch gets a u so large that it needs no impulse.
void whole_step(Motion<double>& s, const StepConstants& k) {
  constexpr double kFar = 1e9;  // m/s
  methods::half_step(s, k);
  const LowCorners low = methods::low_corners(k.half, std::cos(s.theta), std::sin(s.theta), s.y);
  TwoCorners<double> problem = methods::side_problem(s, low, k);
  const bool both = methods::side_touches(low, s, k);
  const bool left = both || low.gap_left <= 0, right = both || low.gap_right <= 0;
  if (!left) problem.u[0] = kFar;
  if (!right) problem.u[1] = kFar;
  if (left != right) {
    problem.r_y = left ? low.left.y : low.right.y;
    problem.u_t = s.v_x - problem.r_y * s.omega + k.dv_x;
  }
  const SideImpulse<double> p = methods::solve_two_corners(problem);
  if (both) {
    methods::push_side(s, low, p, k);
  } else if (left || right) {
    methods::apply_impulse(s, left ? low.left : low.right, p.n[left ? 0 : 1], p.t,
                           k.gyration_squared);
  }
  s.v_x += k.dv_x;
  s.v_y += k.dv_y;
  methods::half_step(s, k);
}

}  // namespace

Trajectory simulate_scene(const Parameters& params, const State& start, ModelReport* report) {
  ModelReport unread;
  return LeastModelSimulation(params, start, report ? *report : unread).run();
}

Trajectory simulate_whole(const Parameters& params, const State& start) {
  Trajectory trajectory = empty_trajectory(params, start);
  const StepConstants k(params);
  Motion<double> s = methods::motion_of<double>(start);
  for (int t = 1; t < params.T; ++t) {
    whole_step(s, k);
    put(trajectory, t, s);
  }
  return trajectory;
}

Trajectory simulate_moreau_jean(const Parameters& params, const State& start) {
  Trajectory trajectory = empty_trajectory(params, start);
  methods::MoreauJean<2> scheme(params, methods::motion_of<double>(start));
  for (int t = 1; t < params.T; ++t) {
    scheme.steps(1);
    put(trajectory, t, scheme.motion());
  }
  return trajectory;
}

}  // namespace bounce::exact
