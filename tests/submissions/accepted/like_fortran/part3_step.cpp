#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce
{

State step(const Vector3& q, const Vector3& v, const Parameters& params)
{
  double f[3], mass[3], corr;
  int k;
  State s;

  mass[0] = params.m;
  mass[1] = params.m;
  mass[2] = params.m*params.l*params.l/6.0;
  for (k = 0; k < 3; k++)
    f[k] = mass[k]*params.g(k);
  corr = 0.0;

  Contact c = get_contacts(q, params);
  if (c.phi < params.delta) {
    Lcp z = form_lcp(c.J, v, params);
    Vector3 fc = solve_lcp(z.V, z.p);
    for (k = 0; k < 3; k++)
      f[k] += c.J(k,1)*fc(0) - c.J(k,0)*fc(1) + c.J(k,0)*fc(2);
    corr = params.delta;
  }

  for (k = 0; k < 3; k++) {
    s.v(k) = v(k) + params.dt*f[k]/mass[k];
    s.q(k) = q(k) + params.dt*s.v(k);
  }
  s.q(1) += corr;
  return s;
}

}
