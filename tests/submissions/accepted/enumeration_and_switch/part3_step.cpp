#include <bounce/part1_contacts.hpp>
#include <bounce/part3_step.hpp>
#include <cmath>

namespace bounce {
namespace {

enum class Mode { flies, leaves, sticks, slides_left, slides_right };

// The contact in numbers: J^T M^-1 J = (tt, tn; tn, nn), and what has to vanish.
struct Numbers {
  double tt, tn, nn, t, n;
};

Numbers numbers_of(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double k = 6 / (params.l * params.l);
  const Vector3 u = v + params.dt * params.g;
  const double a = J(2, 0), b = J(2, 1);
  return {(1 + k * a * a) / params.m, k * a * b / params.m, (1 + k * b * b) / params.m,
          u(0) + a * u(2), u(1) + b * u(2) + params.epsilon * (v(1) + b * v(2))};
}

Mode mode_of(const Numbers& c, double mu) {
  if (c.n >= 0) return Mode::leaves;
  const double det = c.tt * c.nn - c.tn * c.tn;
  const double stick_t = (c.tn * c.n - c.nn * c.t) / det, stick_n = (c.tn * c.t - c.tt * c.n) / det;
  if (std::fabs(stick_t) <= mu * stick_n) return Mode::sticks;
  return c.t * c.nn - c.tn * c.n > 0 ? Mode::slides_right : Mode::slides_left;
}

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Numbers c = numbers_of(contact.J, v, params);
  const Mode mode = contact.phi < params.delta ? mode_of(c, params.mu) : Mode::flies;

  double t = 0, n = 0;  // impulses
  switch (mode) {
    case Mode::flies:
    case Mode::leaves:
      break;
    case Mode::sticks:
      t = (c.tn * c.n - c.nn * c.t) / (c.tt * c.nn - c.tn * c.tn);
      n = (c.tn * c.t - c.tt * c.n) / (c.tt * c.nn - c.tn * c.tn);
      break;
    case Mode::slides_left:
      n = -c.n / (c.nn + params.mu * c.tn);
      t = params.mu * n;
      break;
    case Mode::slides_right:
      n = -c.n / (c.nn - params.mu * c.tn);
      t = -params.mu * n;
      break;
  }

  State next;
  next.v = v + params.dt * params.g;
  next.v(0) += t / params.m;
  next.v(1) += n / params.m;
  next.v(2) += (contact.J(2, 0) * t + contact.J(2, 1) * n) * 6 / (params.m * params.l * params.l);
  next.q = q + params.dt * next.v;
  if (mode != Mode::flies) next.q(1) += params.delta;
  return next;
}

}  // namespace bounce
