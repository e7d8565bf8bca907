#include <bounce/part2_lcp.hpp>
#include <valarray>

namespace bounce
{

typedef std::valarray<double> vec;

static double dot(const vec& a, const vec& b)
{
  return vec(a*b).sum();
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params)
{
  int i, j;
  Lcp z;
  vec w(3), vel(3), g(3), d[3];

  w[0] = w[1] = 1.0/params.m;
  w[2] = 6.0/params.m/params.l/params.l;
  for (i = 0; i < 3; i++) {
    vel[i] = v(i);
    g[i] = params.g(i);
  }
  d[0].resize(3);
  d[1].resize(3);
  for (i = 0; i < 3; i++) {
    d[0][i] = J(i,1);
    d[1][i] = -J(i,0);
  }
  d[2].resize(3);
  d[2] = -d[1];

  for (i = 0; i < 3; i++) {
    for (j = 0; j < 3; j++)
      z.V(i,j) = params.dt*dot(d[i], vec(w*d[j]));
    z.V(i,3) = 1.0;
    z.V(3,i) = -1.0;
    z.p(i) = dot(d[i], vel) + params.dt*dot(d[i], g);
  }
  z.V(0,3) = 0.0;
  z.V(3,0) = params.mu;
  z.V(3,3) = 0.0;
  z.p(0) += params.epsilon*dot(d[0], vel);
  z.p(3) = 0.0;
  return z;
}

}
