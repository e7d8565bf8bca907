#include <bounce/part1_contacts.hpp>
#include <cmath>

using namespace std;

namespace bounce {

typedef long double real;

Contact get_contacts(const Vector3& q, const Parameters& params)
{
    real th = q[2];
    real h = (real)params.l / 2.0L;
    real c = cosl(th);
    real s = sinl(th);

    real sx[4] = {  h, -h, -h,  h };
    real sy[4] = {  h,  h, -h, -h };
    real rx = 0, ry = 0;
    for (int k = 0; k < 4; k++) {
        real x = c*sx[k] - s*sy[k];
        real y = s*sx[k] + c*sy[k];
        if (k == 0 || y < ry) { rx = x; ry = y; }
    }

    Contact result;
    result.phi = (double)((real)q[1] + ry);
    result.J << 1, 0, 0, 1, (double)-ry, (double)rx;
    return result;
}

}
