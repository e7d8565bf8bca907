#pragma once

class Square
{
public:
	Square(double side, double angle);
	Eigen::Vector2d LowestCorner() const;

private:
	double m_side;
	double m_angle;
};
