#include <bounce/part2_lcp.hpp>

namespace bounce
{

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params)
{
  double jh[3][3], mi[3], pt;
  int i, j, k;
  Lcp z;

  /* inverse of the inertia matrix, diagonal */
  mi[0] = 1.0/params.m;
  mi[1] = 1.0/params.m;
  mi[2] = 6.0/(params.m*params.l*params.l);

  /* columns: n, -t, t */
  for (k = 0; k < 3; k++) {
    jh[k][0] =  J(k,1);
    jh[k][1] = -J(k,0);
    jh[k][2] =  J(k,0);
  }

  for (i = 0; i < 3; i++) {
    for (j = 0; j < 3; j++) {
      z.V(i,j) = 0.0;
      for (k = 0; k < 3; k++)
        z.V(i,j) += jh[k][i]*mi[k]*jh[k][j]*params.dt;
    }
  }
  z.V(0,3) = 0.0;
  z.V(1,3) = 1.0;
  z.V(2,3) = 1.0;
  z.V(3,0) = params.mu;
  z.V(3,1) = -1.0;
  z.V(3,2) = -1.0;
  z.V(3,3) = 0.0;

  z.p(0) = 0.0;
  pt = 0.0;
  for (k = 0; k < 3; k++) {
    z.p(0) += jh[k][0]*((1.0 + params.epsilon)*v(k) + params.dt*params.g(k));
    pt     += jh[k][2]*(v(k) + params.dt*params.g(k));
  }
  z.p(1) = -pt;
  z.p(2) =  pt;
  z.p(3) = 0.0;
  return z;
}

}
