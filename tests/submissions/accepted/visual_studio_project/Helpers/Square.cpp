#include "../pch.h"

Square::Square(double side, double angle)
	: m_side(side), m_angle(angle)
{
}

Eigen::Vector2d Square::LowestCorner() const
{
	Eigen::Vector2d lowest(0.0, 0.0);
	for (int k = 0; k < 4; ++k)
	{
		const double a = m_angle + M_PI_4 + k * M_PI_2;
		const Eigen::Vector2d corner = m_side * M_SQRT1_2 * Eigen::Vector2d(cos(a), sin(a));
		if (corner.y() < lowest.y())
			lowest = corner;
	}
	return lowest;
}
