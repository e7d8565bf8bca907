#include <bounce/render.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "drawing.hpp"
#include "study/page.hpp"

namespace bounce {
namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& sentence) {
  throw std::invalid_argument("cannot draw: " + sentence);
}

void require_finite(const Eigen::Matrix3Xd& q, const std::string& name) {
  for (Eigen::Index t = 0; t < q.cols(); ++t) {
    if (!q.col(t).allFinite())
      refuse("column " + std::to_string(t) + " of " + name + " holds NaN or infinity");
  }
}

json rows_of(const Eigen::Matrix3Xd& q) {
  json rows;
  for (const auto& row : q.rowwise()) rows.push_back(std::vector(row.begin(), row.end()));
  return rows;
}

}  // namespace

json data_of(const Drawing& drawing) {
  const auto& [trajectory, p, many, title, about] = drawing;
  const auto& [q, v] = trajectory;
  const double all = p.l + p.dt + p.delta + p.m + p.mu + p.epsilon + p.g.sum();
  if (!(p.l > 0 && p.dt > 0) || !std::isfinite(all))
    refuse("all parameters must be finite, and l and dt positive");
  if (q.cols() == 0) refuse("q has no column");
  if (v.cols() > 0 && v.cols() != q.cols())
    refuse("q has " + std::to_string(q.cols()) + " columns, and v has " + std::to_string(v.cols()));
  require_finite(q, "q");
  require_finite(v, "v");
  json data{{"l", p.l},        {"dt", p.dt},     {"delta", p.delta},
            {"q", rows_of(q)}, {"title", title}, {"about", about}};
  data["motion"] = nullptr;
  if (v.cols() > 0) {
    data["motion"] = {{"m", p.m}, {"mu", p.mu}, {"epsilon", p.epsilon}, {"v", rows_of(v)}};
    data["motion"]["g"] = {p.g.x(), p.g.y()};
  }
  for (const Eigen::Matrix3Xd& one : many) data["many"].push_back(rows_of(one));
  return data;
}

void draw(const Drawing& drawing, const std::filesystem::path& page) {
  check::write(page, study::page_with("render.html", data_of(drawing)));
}

void render(const Eigen::Matrix3Xd& q, const Parameters& params,
            const std::filesystem::path& page) {
  draw({{q, Eigen::Matrix3Xd(3, 0)}, params}, page);
}

void render(const Trajectory& trajectory, const Parameters& params,
            const std::filesystem::path& page) {
  draw({trajectory, params}, page);
}

}  // namespace bounce
