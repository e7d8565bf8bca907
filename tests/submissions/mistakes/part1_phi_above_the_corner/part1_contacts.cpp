#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params)
{
    const Eigen::Vector2d com = q.head<2>();
    const double theta = q(2);
    Eigen::Matrix2d R;
    R << cos(theta), -sin(theta), sin(theta), cos(theta);

    const double half = 0.5 * params.l;
    const Eigen::Vector2d local[4] = {{half, half}, {-half, half}, {-half, -half}, {half, -half}};

    Eigen::Vector2d contact_point = com + R * local[0];
    for (int i = 1; i < 4; i++)
    {
        const Eigen::Vector2d p = com + R * local[i];
        if (p(1) < contact_point(1))
        {
            contact_point = p;
        }
    }

    const double phi = com(1) - contact_point(1);
    const Eigen::Vector2d r = contact_point - com;

    Jacobian J;
    J << 1, 0,
         0, 1,
         -r(1), r(0);
    return {J, phi};
}

}
