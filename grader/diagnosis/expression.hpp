// Evaluates a formula that is written as text: "y - (l/2) abs(cos(theta))".
#pragma once

#include <map>
#include <string>

namespace bounce::tests {

using Symbols = std::map<std::string, double>;

// The value of + - / ^, of products without a sign ("2 mu dt"), and of cos, sin, sqrt, abs, round,
// min and max. corner_x(angle) and corner_y(angle) lead from the centre of a square of the side l,
// turned by the angle, to its lowest corner. Throws std::exception if a symbol is unknown.
double value(const std::string& formula, const Symbols& symbols);

// From the centre of a square to its lowest corner: x and y.
struct Corner {
  double x, y;
};
Corner lowest_corner(double angle, double side);

}  // namespace bounce::tests
