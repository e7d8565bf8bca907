#include "picture.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bounce::tests {
namespace {

// Of the world, m; or a way between two points.
struct Point {
  double x, y;
};

constexpr int kWidth = 58, kHeight = 17;  // fits a terminal of 64 columns
constexpr double kAspect = 2.0;           // a character is about twice as high as wide
constexpr const char* kMargin = "    | ";

// A picture of a part of the world, made of letters; x and y in m, with one scale.
class Canvas {
 public:
  Canvas(const Point& low, const Point& high) {
    metres_ = std::max(std::max(high.x - low.x, 1e-9) / (kWidth - 1),
                       std::max(high.y - low.y, 1e-9) / (kAspect * (kHeight - 1)));
    left_ = (low.x + high.x - metres_ * (kWidth - 1)) / 2;
    bottom_ = low.y;
    rows_.assign(kHeight, std::string(kWidth, ' '));
  }

  // The point at the middle of a letter.
  Point at(int column, int row) const {
    return {left_ + metres_ * column, bottom_ + kAspect * metres_ * row};
  }

  void ground() {
    for (int row = 0; row < kHeight; ++row) {
      if (std::abs(at(0, row).y) <= kAspect * metres_ / 2) letters(row) = std::string(kWidth, '=');
    }
  }

  // Draws a letter, unless the point is outside the picture or not a number.
  void put(const Point& point, char letter) {
    const double column = std::round((point.x - left_) / metres_);
    const double row = std::round((point.y - bottom_) / (kAspect * metres_));
    if (!(column >= 0 && column < kWidth && row >= 0 && row < kHeight)) return;
    char& there = letters(static_cast<int>(row))[static_cast<std::size_t>(column)];
    const bool over = (letter == 'Y' && (there == 'R' || there == 'B'));
    there = over ? 'B' : letter;
  }

  void line(const Point& from, const Point& to, char letter) {
    for (int i = 1; i <= 2 * kWidth; ++i) {
      put({from.x + (to.x - from.x) * i / (2.0 * kWidth),
           from.y + (to.y - from.y) * i / (2.0 * kWidth)},
          letter);
    }
  }

  std::string text(const std::string& legend) const {
    std::string all;
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      const auto end = row->find_last_not_of(' ');
      if (end != std::string::npos) all += kMargin + row->substr(0, end + 1) + "\n";
    }
    return all + kMargin + legend;
  }

 private:
  std::string& letters(int row) { return rows_[static_cast<std::size_t>(row)]; }

  double metres_, left_, bottom_;  // metres per letter, and the picture's lower left corner
  std::vector<std::string> rows_;  // from the bottom up
};

bool touches(const Case& c) { return c.corner.rfind("corner", 0) == 0; }

// How far inside the square a point is, m; negative outside.
double inside(const Point& point, const Vector3& q, double l) {
  const double x = point.x - q(0), y = point.y - q(1);
  const double c = std::cos(q(2)), s = std::sin(q(2));
  return l / 2 - std::max(std::abs(c * x + s * y), std::abs(c * y - s * x));
}

// Draws the outline of the square, and returns the position of its lowest letter.
Point draw_square(Canvas& canvas, const Vector3& q, double l) {
  Point lowest{q(0), q(1)};
  for (int row = kHeight - 1; row >= 0; --row) {
    for (int column = 0; column < kWidth; ++column) {
      const Point point = canvas.at(column, row);
      const double depth = inside(point, q, l);
      if (depth >= 0 && depth <= 0.06 * l) canvas.put(point, '#');
      if (depth >= 0) lowest = point;
    }
  }
  return lowest;
}

}  // namespace

std::string picture_of_step(const Case& c, const Vector3& got_v) {
  const double l = c.params.l;
  const Point centre{c.q(0), c.q(1)}, reach{0.9 * l, 0.8 * l};
  const bool near = centre.y < 1.5 * l;
  const double low = near ? std::min(centre.y - reach.y, -0.05 * l) : centre.y - reach.y;
  Canvas canvas({centre.x - reach.x, low}, {centre.x + reach.x, centre.y + reach.y});
  if (near) canvas.ground();
  const Point lowest = draw_square(canvas, c.q, l);

  const Vector3& right_v = c.state.v;
  const double longest =
      std::max({std::hypot(right_v(0), right_v(1)), std::hypot(got_v(0), got_v(1)), 1e-9});
  const double metres = 0.7 * l / longest;  // for 1 m/s
  const auto tip = [&](const Vector3& v) {
    return Point{centre.x + metres * v(0), centre.y + metres * v(1)};
  };
  canvas.line(centre, tip(right_v), 'R');
  canvas.line(centre, tip(got_v), 'Y');
  canvas.put(centre, '+');
  if (touches(c)) canvas.put(lowest, 'o');
  return canvas.text("v of the centre + after the step: R right, Y yours, B both");
}

std::string picture_of_paths(const Case& c, const Eigen::Matrix3Xd& got_q) {
  const Eigen::Matrix3Xd& right = c.trajectory.q;
  Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (Eigen::Index i = 0; i < right.cols(); ++i) {
    low = {std::min(low.x, right(0, i)), std::min(low.y, right(1, i))};
    high = {std::max(high.x, right(0, i)), std::max(high.y, right(1, i))};
  }
  const Point room{0.1 * std::max(high.x - low.x, c.params.l),
                   0.1 * std::max(high.y - low.y, c.params.l)};
  Canvas canvas({low.x - room.x, std::min(low.y, 0.0)}, {high.x + room.x, high.y + room.y});
  canvas.ground();
  for (Eigen::Index i = 0; i < right.cols(); ++i) canvas.put({right(0, i), right(1, i)}, 'R');
  const Eigen::Index known = c.columns.empty() ? 0 : c.columns.back() + 1;
  for (Eigen::Index i = 0; i < std::min(known, got_q.cols()); ++i) {
    canvas.put({got_q(0, i), got_q(1, i)}, 'Y');
  }
  return canvas.text("way of the centre: R right, Y yours, B both");
}

}  // namespace bounce::tests
