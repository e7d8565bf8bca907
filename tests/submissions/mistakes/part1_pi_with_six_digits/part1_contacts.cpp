#include <bounce/part1_contacts.hpp>
#include <cmath>

#define PI 3.14159

namespace bounce {

// bring the angle back to -pi..pi
static double normalise(double a)
{
	while (a > PI) a -= 2 * PI;
	while (a < -PI) a += 2 * PI;
	return a;
}

Contact get_contacts(const Vector3& q, const Parameters& params)
{
	double theta = normalise(q(2));
	double h = params.l / 2;

	double xs[4], ys[4];
	int n = 0;
	for (int i = -1; i < 2; i += 2)
	{
		for (int j = -1; j < 2; j += 2)
		{
			xs[n] = i * h * cos(theta) - j * h * sin(theta);
			ys[n] = i * h * sin(theta) + j * h * cos(theta);
			n++;
		}
	}

	int best = 0;
	for (n = 1; n < 4; n++)
		if (ys[n] < ys[best])
			best = n;

	Jacobian J;
	J << 1, 0,
	     0, 1,
	     -ys[best], xs[best];
	return { J, q(1) + ys[best] };
}

}
