#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

#define DO(k, n) for (int k = 0; k < (n); k++)
#define JT(k) c.J(k,0)
#define JN(k) c.J(k,1)

namespace bounce
{

State step(const Vector3& q, const Vector3& v, const Parameters& params)
{
  double f[3] = { 0.0, 0.0, 0.0 };
  double w[3] = { 1.0/params.m, 1.0/params.m, 6.0/(params.m*params.l*params.l) };
  double corr = 0.0;
  Vector3 z = Vector3::Zero();
  Lcp lcp;
  State s;
  Contact c = get_contacts(q, params);

  if (!(c.phi < params.delta)) goto move;

  lcp = form_lcp(c.J, v, params);
  z = solve_lcp(lcp.V, lcp.p);
  DO(k, 3) f[k] = JN(k)*z(0) - JT(k)*z(1) + JT(k)*z(2);
  corr = params.delta;

move:
  DO(k, 3) s.v(k) = v(k) + params.dt*(params.g(k) + w[k]*f[k]);
  DO(k, 3) s.q(k) = q(k) + params.dt*s.v(k);
  s.q(1) += corr;
  return s;
}

}
