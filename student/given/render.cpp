#include <bounce/render.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "drawing.hpp"
#include "pages.hpp"  // which page/pages.cmake makes

namespace fs = std::filesystem;

namespace bounce {
namespace {

constexpr std::string_view kData = "DATA";  // stands in the page for what it draws

// The shortest digits that read back as the same number, whatever the locale.
std::string digits(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

[[noreturn]] void refuse(const std::string& sentence) {
  throw std::invalid_argument("cannot draw: " + sentence);
}

void require_finite(const Eigen::Matrix3Xd& q, const std::string& name) {
  for (Eigen::Index t = 0; t < q.cols(); ++t) {
    if (!q.col(t).allFinite())
      refuse("column " + std::to_string(t) + " of " + name + " holds NaN or infinity");
  }
}

std::string json(const Eigen::Matrix3Xd& q) {
  std::string rows;
  for (const auto& row : q.rowwise()) {
    std::string numbers;
    for (const double value : row) numbers += (numbers.empty() ? "" : ",") + digits(value);
    rows += (rows.empty() ? "[" : ",[") + numbers + "]";
  }
  return "[" + rows + "]";
}

std::string motion(const Eigen::Matrix3Xd& v, const Parameters& params) {
  return R"({"m":)" + digits(params.m) + R"(,"mu":)" + digits(params.mu) + R"(,"epsilon":)" +
         digits(params.epsilon) + R"(,"g":[)" + digits(params.g.x()) + "," + digits(params.g.y()) +
         R"(],"v":)" + json(v) + "}";
}

[[noreturn]] void fail_to_write(const fs::path& page, const std::string& reason) {
  throw std::runtime_error("cannot write " + page.string() + ": " + reason);
}

// Renaming a file is atomic, so a reader sees the old page or the new one, never half of one.
void replace(const fs::path& page, std::string_view text) {
  if (fs::exists(page) && !fs::is_regular_file(page))
    fail_to_write(page, "it is there already and is not a file");
  fs::path part = page;
  part += ".part";

  std::ofstream out(part, std::ios::binary);
  if (!out) fail_to_write(page, "its folder is missing or may not be written to");
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();

  std::error_code renamed;
  if (out) fs::rename(part, page, renamed);
  if (out && !renamed) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  fail_to_write(page, out ? renamed.message() : "the disk may be full");
}

}  // namespace

std::string data_of(const Drawing& drawing) {
  const auto& [trajectory, params, many, title] = drawing;
  const auto& [q, v] = trajectory;
  const double all = params.l + params.dt + params.delta + params.m + params.mu + params.epsilon;
  if (!(params.l > 0 && params.dt > 0) || !std::isfinite(all + params.g.sum()))
    refuse("all parameters must be finite, and l and dt positive");
  if (q.cols() == 0) refuse("q has no column");
  if (v.cols() > 0 && v.cols() != q.cols())
    refuse("q has " + std::to_string(q.cols()) + " columns, and v has " + std::to_string(v.cols()));
  require_finite(q, "q");
  require_finite(v, "v");
  std::string others;
  for (const Eigen::Matrix3Xd& one : many) others += (others.empty() ? "" : ",") + json(one);
  return R"({"l":)" + digits(params.l) + R"(,"dt":)" + digits(params.dt) + R"(,"delta":)" +
         digits(params.delta) + R"(,"q":)" + json(q) + R"(,"motion":)" +
         (v.cols() > 0 ? motion(v, params) : "null") + R"(,"many":[)" + others + R"(],"title":")" +
         title + "\"}";
}

void draw(const Drawing& drawing, const fs::path& page) {
  std::string text(pages::render);
  replace(page, text.replace(text.find(kData), kData.size(), data_of(drawing)));
}

void render(const Eigen::Matrix3Xd& q, const Parameters& params, const fs::path& page) {
  draw({{q, Eigen::Matrix3Xd(3, 0)}, params}, page);
}

void render(const Trajectory& trajectory, const Parameters& params, const fs::path& page) {
  draw({trajectory, params}, page);
}

}  // namespace bounce
