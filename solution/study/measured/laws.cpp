#include "laws.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "compliant.hpp"
#include "methods/impact_laws.hpp"
#include "methods/two_corners.hpp"

namespace bounce::measured {
namespace {

using methods::Arm;
using methods::Collision;
using methods::CornerImpulse;
using methods::ImpactLaw;
using methods::Motion;
using methods::Row;

Motion<double> before(const Impact& hit) { return {0, 0, 0, hit.v_x, hit.v_y, hit.omega}; }

Velocity velocity(const Motion<double>& s) { return {s.v_x, s.v_y, s.omega}; }

Collision<double> collision(const Motion<double>& s, const Arm<double>& r, double gyration_squared,
                            const Setting& with) {
  const auto k = methods::one_corner(r, gyration_squared, 0.0, 0.0, with.mu);
  return {
      k.a,     k.b,         k.c, methods::normal_velocity(s, r), methods::tangential_velocity(s, r),
      with.mu, with.epsilon};
}

// Applies what `law` gives for one corner; nothing where the corner doesn't approach.
template <class CornerLaw>
void strike(Motion<double>& s, const Arm<double>& r, double gyration_squared, const Setting& with,
            CornerLaw law) {
  const Collision<double> k = collision(s, r, gyration_squared, with);
  if (k.v_n >= 0) return;
  const CornerImpulse<double> p = law(k);
  methods::apply_impulse(s, r, p.n, p.t, gyration_squared);
}

template <class CornerLaw>
Velocity one_corner(const Impact& hit, const Setting& with, CornerLaw law) {
  Motion<double> s = before(hit);
  strike(s, hit.corner, hit.gyration_squared, with, law);
  return velocity(s);
}

Velocity frictionless(const Impact& hit, const Setting& with) {
  return one_corner(hit, with, [](Collision<double> k) {
    k.mu = 0;
    return methods::impact(k, ImpactLaw::newton);
  });
}

// v_t = 0 after the impact, whatever friction that takes.
Velocity sticking(const Impact& hit, const Setting& with) {
  return one_corner(hit, with, [](const Collision<double>& k) -> CornerImpulse<double> {
    const double u_n = (1 + k.epsilon) * k.v_n, D = k.a * k.c - k.b * k.b;
    const double n = std::max(0.0, (k.b * k.v_t - k.c * u_n) / D);
    return {n, -(k.v_t + k.b * n) / k.c, methods::ContactMode::sticks};
  });
}

template <ImpactLaw law>
Velocity followed(const Impact& hit, const Setting& with) {
  return one_corner(hit, with, [](const Collision<double>& k) { return methods::impact(k, law); });
}

CornerImpulse<double> compression(const Collision<double>& k) {
  return methods::solve_one_corner<double>({k.a, k.b, k.c, k.v_n, k.v_t, k.mu});
}

// Friction acts in compression only; expansion returns epsilon of the normal impulse.
Velocity poisson_normal(const Impact& hit, const Setting& with) {
  return one_corner(hit, with, [](const Collision<double>& k) -> CornerImpulse<double> {
    const auto p = compression(k);
    return {(1 + k.epsilon) * p.n, p.t, p.mode};
  });
}

// As above, but returns epsilon^2 of the normal work: a s^2 / 2 = epsilon^2 |v_n| p_n / 2.
Velocity stronge_normal(const Impact& hit, const Setting& with) {
  return one_corner(hit, with, [](const Collision<double>& k) -> CornerImpulse<double> {
    const auto p = compression(k);
    return {p.n + k.epsilon * std::sqrt(-k.v_n * p.n / k.a), p.t, p.mode};
  });
}

Velocity compliant(const Impact& hit, const Setting& with) {
  const double zeta = methods::damping_ratio(with.epsilon);
  return one_corner(
      hit, with, [&](const Collision<double>& k) { return compliant_impact(k, zeta, with.kappa); });
}

// One corner after the other within kWhile, by the given law; the arms stay as
// they are.
template <ImpactLaw law>
Velocity corner_after_corner(const Impact& hit, const Setting& with) {
  constexpr double kWhile = 0.008;  // s: two rows
  constexpr int kMost = 20;
  const Arm<double> arms[] = {hit.corner, hit.other};
  double gaps[] = {0, hit.other.y - hit.corner.y};
  Motion<double> s = before(hit);
  double left = kWhile;
  for (int strikes = 0; strikes < kMost; ++strikes) {
    int next = -1;
    double wait = left;
    for (int i = 0; i < 2; ++i) {
      const double v_n = methods::normal_velocity(s, arms[i]);
      if (v_n < 0 && gaps[i] <= -v_n * wait) next = i, wait = gaps[i] / -v_n;
    }
    if (next < 0) break;
    left -= wait;
    for (int i = 0; i < 2; ++i)
      gaps[i] = std::max(0.0, gaps[i] + wait * methods::normal_velocity(s, arms[i]));
    strike(s, arms[next], hit.gyration_squared, with,
           [](const Collision<double>& k) { return methods::impact(k, law); });
  }
  return velocity(s);
}

// Both corners at once.
class Side {
 public:
  Side(const Impact& hit, double mu) : hit_(hit), mu_(mu), s_(before(hit)) {}

  double approach(const Arm<double>& r) const { return methods::normal_velocity(s_, r); }

  Row<double, 2> press(double epsilon, double P_0) {
    const auto u = [&](const Arm<double>& r) {
      const double v_n = approach(r);
      return v_n + epsilon * std::min(v_n, 0.0);
    };
    const double r_y = (hit_.corner.y + hit_.other.y) / 2, u_t = s_.v_x - r_y * s_.omega;
    const auto k = methods::two_corners(hit_.corner, hit_.other, hit_.gyration_squared,
                                        {{u(hit_.corner), u(hit_.other)}}, u_t, mu_, P_0);
    const auto p = methods::solve_two_corners(k);
    push(p.n, p.t);
    return p.n;
  }

  void push(const Row<double, 2>& n, double t) {
    methods::apply_impulse(s_, hit_.corner, n[0], t / 2, hit_.gyration_squared);
    methods::apply_impulse(s_, hit_.other, n[1], t / 2, hit_.gyration_squared);
  }

  Velocity after() const { return velocity(s_); }

 private:
  const Impact& hit_;
  double mu_;
  Motion<double> s_;
};

Velocity two_frictionless(const Impact& hit, const Setting& with) {
  Side side(hit, 0);
  side.press(with.epsilon, 0);
  return side.after();
}

Velocity two_newton(const Impact& hit, const Setting& with) {
  Side side(hit, with.mu);
  side.press(with.epsilon, 0);
  return side.after();
}

// Glocker and Pfeiffer's expansion, as in exact/event_driven.cpp.
Velocity two_poisson(const Impact& hit, const Setting& with) {
  Side side(hit, with.mu);
  const Row<double, 2> p = side.press(0, 0);
  const Row<double, 2> back{with.epsilon * p[0], with.epsilon * p[1]};
  side.push(back, 0);
  side.press(0, back[0] + back[1]);
  return side.after();
}

constexpr NamedLaw kLaws[] = {
    {"frictionless", frictionless},
    {"sticking", sticking},
    {"newton", followed<ImpactLaw::newton>},
    {"poisson_normal", poisson_normal},
    {"stronge_normal", stronge_normal},
    {"routh_poisson", followed<ImpactLaw::poisson>},
    {"routh_stronge", followed<ImpactLaw::stronge>},
    {"compliant", compliant},
    {"two_frictionless", two_frictionless},
    {"sequence_newton", corner_after_corner<ImpactLaw::newton>},
    {"sequence_routh", corner_after_corner<ImpactLaw::stronge>},
    {"two_newton", two_newton},
    {"two_poisson", two_poisson},
};

}  // namespace

std::span<const NamedLaw> laws() { return kLaws; }

Law law_named(std::string_view name) {
  for (const NamedLaw& law : kLaws)
    if (law.name == name) return law.after;
  throw std::invalid_argument("there is no law " + std::string(name));
}

}  // namespace bounce::measured
