#include <bounce/part1_contacts.hpp>
#include <math.h>

namespace bounce
{

Contact get_contacts(const Vector3& q, const Parameters& params)
{
  static const double sx[4] = {  0.5, -0.5, -0.5,  0.5 };
  static const double sy[4] = {  0.5,  0.5, -0.5, -0.5 };
  double rx[4], ry[4], ct, st;
  int k, kmin;
  Contact c;

  ct = cos(q(2));
  st = sin(q(2));
  for (k = 0; k < 4; k++) {
    rx[k] = params.l*(ct*sx[k] - st*sy[k]);
    ry[k] = params.l*(st*sx[k] + ct*sy[k]);
  }

  kmin = 0;
  for (k = 1; k < 4; k++)
    if (ry[k] < ry[kmin])
      kmin = k;

  c.J(0,0) = 1.0;       c.J(0,1) = 0.0;
  c.J(1,0) = 0.0;       c.J(1,1) = 1.0;
  c.J(2,0) = -ry[kmin]; c.J(2,1) = rx[kmin];
  c.phi = q(1) + ry[kmin];
  return c;
}

}
