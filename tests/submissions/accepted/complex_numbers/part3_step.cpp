#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <complex>

namespace bounce {

using Complex = std::complex<double>;

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  Complex pos(q(0), q(1));
  Complex vel(v(0), v(1));
  double omega = v(2);

  // gravity
  Complex acc(params.g(0), params.g(1));
  double alpha = params.g(2);
  Complex lift(0.0, 0.0);

  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    const Complex F(f(2) - f(1), f(0));  // the ground's push at the corner
    const Complex r(contact.J(2, 1), -contact.J(2, 0));
    const double I = params.m * params.l * params.l / 6;
    acc += F / params.m;
    alpha += (std::conj(r) * F).imag() / I;  // r x F
    lift = Complex(0.0, params.delta);
  }

  vel += params.dt * acc;
  omega += params.dt * alpha;
  pos += params.dt * vel + lift;
  return {Vector3(pos.real(), pos.imag(), q(2) + params.dt * omega),
          Vector3(vel.real(), vel.imag(), omega)};
}

}  // namespace bounce
