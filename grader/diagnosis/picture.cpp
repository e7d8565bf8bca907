#include "picture.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bounce::tests {
namespace {

using Point = Eigen::Vector2d;  // of the world, m

constexpr int kWidth = 58, kHeight = 17;  // fits a terminal of 64 columns
constexpr double kAspect = 2.0;           // a character is about twice as high as wide
constexpr const char* kMargin = "    | ";

// A picture of a part of the world, made of letters; with one scale.
class Canvas {
 public:
  Canvas(const Point& low, const Point& high) : rows_(kHeight, std::string(kWidth, ' ')) {
    const Point size = (high - low).cwiseMax(1e-9);
    metres_ = std::max(size.x() / (kWidth - 1), size.y() / (kAspect * (kHeight - 1)));
    corner_ = {(low.x() + high.x() - metres_ * (kWidth - 1)) / 2, low.y()};
  }

  // The point at the middle of a letter.
  Point at(int column, int row) const { return corner_ + metres_ * Point(column, kAspect * row); }

  void ground() {
    for (int column = 0; column < kWidth; ++column) put({at(column, 0).x(), 0}, '=');
  }

  // Draws a letter, unless the point is outside the picture or not a number.
  void put(const Point& point, char letter) {
    const double column = std::round((point.x() - corner_.x()) / metres_);
    const double row = std::round((point.y() - corner_.y()) / (kAspect * metres_));
    if (!(column >= 0 && column < kWidth && row >= 0 && row < kHeight)) return;
    char& there = rows_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    const bool over = (letter == 'Y' && (there == 'R' || there == 'B'));
    there = over ? 'B' : letter;
  }

  void line(const Point& from, const Point& to, char letter) {
    for (int i = 1; i <= 2 * kWidth; ++i) put(from + (to - from) * i / (2.0 * kWidth), letter);
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
  double metres_;                  // per letter
  Point corner_;                   // lower left
  std::vector<std::string> rows_;  // from the bottom up
};

// How far inside the square a point is, m; negative outside.
double inside(const Point& point, const Vector3& q, double l) {
  const Point own = Eigen::Rotation2Dd(-q(2)) * (point - q.head(2));
  return l / 2 - own.cwiseAbs().maxCoeff();
}

// Draws the outline of the square, and returns the position of its lowest letter.
Point draw_square(Canvas& canvas, const Vector3& q, double l) {
  Point lowest = q.head(2);
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
  const Point centre = c.q.head(2), reach(0.9 * l, 0.8 * l);
  const bool near = centre.y() < 1.5 * l;
  Point low = centre - reach;
  if (near) low.y() = std::min(low.y(), -0.05 * l);
  Canvas canvas(low, centre + reach);
  if (near) canvas.ground();
  const Point lowest = draw_square(canvas, c.q, l);

  const Point right = c.state.v.head(2), got = got_v.head(2);
  const double metres = 0.7 * l / std::max({right.norm(), got.norm(), 1e-9});  // for 1 m/s
  canvas.line(centre, centre + metres * right, 'R');
  canvas.line(centre, centre + metres * got, 'Y');
  canvas.put(centre, '+');
  if (c.corner.rfind("corner", 0) == 0) canvas.put(lowest, 'o');  // it touches
  return canvas.text("v of the centre + after the step: R right, Y yours, B both");
}

std::string picture_of_paths(const Case& c, const Eigen::Matrix3Xd& got_q) {
  const auto right = c.trajectory.q.topRows<2>();
  const Point low = right.rowwise().minCoeff(), high = right.rowwise().maxCoeff();
  const Point room = 0.1 * (high - low).cwiseMax(c.params.l);
  Canvas canvas({low.x() - room.x(), std::min(low.y(), 0.0)}, high + room);
  canvas.ground();
  for (const Point& point : right.colwise()) canvas.put(point, 'R');
  const Eigen::Index known = c.columns.empty() ? 0 : c.columns.back() + 1;
  for (Eigen::Index i = 0; i < std::min(known, got_q.cols()); ++i) {
    canvas.put(got_q.col(i).head(2), 'Y');
  }
  return canvas.text("way of the centre: R right, Y yours, B both");
}

}  // namespace bounce::tests
