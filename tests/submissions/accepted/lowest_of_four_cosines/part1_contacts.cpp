#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

// the heights of the corners over the centre are l / sqrt(2) * cos(theta + k pi / 4), k odd
Contact get_contacts(const Vector3& q, const Parameters& params)
{
	const double pi = std::acos(-1.0);
	int k_min = 1;
	for (int k = 3; k <= 7; k += 2)
	{
		if (cos(q(2) + k * pi / 4) < cos(q(2) + k_min * pi / 4))
			k_min = k;
	}

	const double a = q(2) + k_min * pi / 4;
	const double rad = params.l / sqrt(2.0);
	const double rx = -rad * sin(a);
	const double ry = rad * cos(a);

	Contact c;
	c.J << 1, 0, 0, 1, -ry, rx;
	c.phi = q(1) + ry;
	return c;
}

}
