#include <bounce/part1_contacts.hpp>
#include <bounce/part3_step.hpp>
#include <algorithm>
#include <array>
#include <cmath>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 J_t = contact.J.col(0);
  const Vector3 J_n = contact.J.col(1);
  const Vector3 u = v + params.dt * params.g;
  if (contact.phi >= params.delta) return {q + params.dt * u, u};

  struct Guess {
    double wrong;  // how far it is from what it assumes, m/s
    double f_n;
    double f_t;
  };
  const Eigen::Matrix2d A = params.dt * contact.J.transpose() * params.M().inverse() * contact.J;
  const double p_n = J_n.dot(u) + params.epsilon * J_n.dot(v);
  const double p_t = J_t.dot(u);

  const auto stick = [&]() -> Guess {
    const Eigen::Vector2d f = A.inverse() * Eigen::Vector2d(-p_t, -p_n);
    return {std::max(0.0, std::abs(f(0)) - params.mu * f(1)) * A(0, 0), f(1), f(0)};
  };
  const auto slide = [&](double side) -> Guess {  // side: of the friction
    const double f_n = -p_n / (A(1, 1) + side * params.mu * A(0, 1));
    const double f_t = side * params.mu * f_n;
    const double left = p_t + A(0, 1) * f_n + A(0, 0) * f_t;
    return {std::max(0.0, side * left), f_n, f_t};
  };

  Guess best{0, 0, 0};
  if (p_n < 0) {
    const std::array<Guess, 3> guesses{stick(), slide(-1), slide(1)};
    best = *std::min_element(guesses.begin(), guesses.end(),
                             [](const Guess& a, const Guess& b) { return a.wrong < b.wrong; });
  }
  const Vector3 v_new = u + params.dt * params.M().inverse() * (J_n * best.f_n + J_t * best.f_t);
  return {q + params.dt * v_new + Vector3(0, params.delta, 0), v_new};
}

}  // namespace bounce
