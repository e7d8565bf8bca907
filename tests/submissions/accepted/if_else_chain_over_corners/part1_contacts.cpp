#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params)
{
    double l = params.l;
    double C = std::cos(q(2));
    double S = std::sin(q(2));

    // A B
    // D C
    double ax = -l / 2 * C - l / 2 * S, ay = -l / 2 * S + l / 2 * C;
    double bx =  l / 2 * C - l / 2 * S, by =  l / 2 * S + l / 2 * C;
    double cx =  l / 2 * C + l / 2 * S, cy =  l / 2 * S - l / 2 * C;
    double dx = -l / 2 * C + l / 2 * S, dy = -l / 2 * S - l / 2 * C;

    double rx, ry;
    if (ay <= by && ay <= cy && ay <= dy) {
        rx = ax;
        ry = ay;
    } else if (by <= ay && by <= cy && by <= dy) {
        rx = bx;
        ry = by;
    } else if (cy <= ay && cy <= by && cy <= dy) {
        rx = cx;
        ry = cy;
    } else {
        rx = dx;
        ry = dy;
    }

    Contact contact;
    contact.phi = q(1) + ry;
    contact.J(0, 0) = 1;
    contact.J(1, 0) = 0;
    contact.J(2, 0) = -ry;
    contact.J(0, 1) = 0;
    contact.J(1, 1) = 1;
    contact.J(2, 1) = rx;
    return contact;
}

}
