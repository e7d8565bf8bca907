#include <bounce/part1_contacts.hpp>
#include <cmath>

using namespace std;

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params)
{
    double y = q[1];
    double th = q[2];
    double h = params.l / 2.0;

    // moment arms of the four corners (world frame)
    double r1x =  h*cos(th) - h*sin(th);
    double r1y =  h*sin(th) + h*cos(th);
    double r2x = -h*cos(th) - h*sin(th);
    double r2y = -h*sin(th) + h*cos(th);
    double r3x = -h*cos(th) + h*sin(th);
    double r3y = -h*sin(th) - h*cos(th);
    double r4x =  h*cos(th) + h*sin(th);
    double r4y =  h*sin(th) - h*cos(th);

    // take the lowest
    double rx = r1x;
    double ry = r1y;
    if (r2y < ry) { rx = r2x; ry = r2y; }
    if (r3y < ry) { rx = r3x; ry = r3y; }
    if (r4y < ry) { rx = r4x; ry = r4y; }

    Contact result;
    result.phi = y + ry;
    result.J(0,0) = 1.0;   result.J(0,1) = 0.0;
    result.J(1,0) = 0.0;   result.J(1,1) = 1.0;
    result.J(2,0) = -ry;   result.J(2,1) = rx;
    return result;
}

}
