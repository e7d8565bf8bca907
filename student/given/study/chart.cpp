#include "chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "page.hpp"

namespace bounce::study {
namespace {

constexpr double kLeft = 74, kRight = 450, kTop = 14, kBottom = 250;  // of the plotted field
constexpr double kLeast = 1e-9;  // a logarithmic axis begins no lower

std::string text(double x, const char* format) {
  char digits[40];
  std::snprintf(digits, sizeof digits, format, x);
  return digits;
}

// From a number to where it stands between two ends of the field.
struct Scale {
  double from, to, begin, end;
  bool logarithmic;

  double of(double x) const {
    const double a = logarithmic ? std::log10(std::max(x, kLeast)) : x;
    return begin + (a - from) / (to - from) * (end - begin);
  }
};

Scale scale_of(const std::vector<double>& numbers, double begin, double end, bool logarithmic) {
  double least = 1e300, most = -1e300;
  for (const double x : numbers) {
    const double a = logarithmic ? std::log10(std::max(x, kLeast)) : x;
    least = std::min(least, a);
    most = std::max(most, a);
  }
  if (logarithmic) return {std::floor(least), std::ceil(most + 1e-9), begin, end, true};
  const double room = std::max(0.05 * (most - least), 1e-3);
  return {least - room, most + room, begin, end, false};
}

std::vector<double> ticks(const Scale& scale) {
  std::vector<double> at;
  if (scale.logarithmic) {
    const double step = scale.to - scale.from > 7 ? 2 : 1;
    for (double a = scale.from; a <= scale.to; a += step) at.push_back(std::pow(10, a));
    return at;
  }
  const double raw = (scale.to - scale.from) / 5, unit = std::pow(10, std::floor(std::log10(raw)));
  const double step = unit * (raw / unit > 5 ? 10 : raw / unit > 2 ? 5 : 2);
  for (double a = std::ceil(scale.from / step) * step; a <= scale.to; a += step) at.push_back(a);
  return at;
}

std::string tick(double x, bool logarithmic) {
  if (!logarithmic) return text(std::abs(x) < 1e-12 ? 0 : x, "%.4g");
  return "10<tspan dy=\"-5\" font-size=\"10\">" + text(std::round(std::log10(x)), "%.0f") +
         "</tspan>";
}

std::string grid(const Scale& x, const Scale& y, const Axes& axes) {
  std::string svg;
  for (const double a : ticks(x)) {
    const std::string at = text(x.of(a), "%.1f");
    svg += "<path class=\"grid\" d=\"M " + at + " 14 V 250\"/><text x=\"" + at +
           "\" y=\"270\" text-anchor=\"middle\">" + tick(a, axes.logarithmic) + "</text>\n";
  }
  for (const double a : ticks(y)) {
    const std::string at = text(y.of(a), "%.1f");
    svg += "<path class=\"grid\" d=\"M 74 " + at + " H 450\"/><text x=\"66\" y=\"" +
           text(y.of(a) + 4, "%.1f") + "\" text-anchor=\"end\">" + tick(a, axes.logarithmic) +
           "</text>\n";
  }
  return svg + "<text x=\"262\" y=\"298\" text-anchor=\"middle\">" + escaped(axes.x) +
         "</text>\n<text transform=\"translate(18 132) rotate(-90)\" text-anchor=\"middle\">" +
         escaped(axes.y) + "</text>\n";
}

std::string drawn(const Line& line, const std::string& kind, const Scale& x, const Scale& y) {
  std::string path, dots;
  for (const auto& [a, b] : line.points) {
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    const std::string at = text(x.of(a), "%.1f") + " " + text(y.of(b), "%.1f");
    path += (path.empty() ? "M " : " L ") + at;
    if (line.points.size() < 30) dots += "M " + at + " h 0 ";
  }
  return "<path class=\"curve " + kind + "\" d=\"" + path + "\"/><path class=\"dots " + kind +
         "\" d=\"" + dots + "\"/>\n";
}

}  // namespace

std::string bars(const std::string& title, const std::vector<Bar>& rows, double most,
                 const std::string& sentence) {
  constexpr double kTall = 48, kWide = 340;  // of a row, and of the longest bar
  std::string svg;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Bar& row = rows[i];
    const double top = kTall * static_cast<double>(i);
    const double wide = std::isfinite(row.value) ? kWide * std::min(row.value / most, 1.0) : 0;
    svg += "<text x=\"1\" y=\"" + text(top + 16, "%.0f") + "\">" + escaped(row.name) +
           "</text><rect class=\"bar" + (row.is_own ? " own" : "") + "\" x=\"1\" y=\"" +
           text(top + 24, "%.0f") + "\" width=\"" + text(wide, "%.1f") +
           "\" height=\"12\"/><text x=\"" + text(wide + 8, "%.1f") + "\" y=\"" +
           text(top + 35, "%.0f") + "\">" + escaped(row.label) +
           (row.value > most && std::isfinite(row.value) ? ", beyond the chart" : "") + "</text>\n";
  }
  return "<figure>\n<h3>" + escaped(title) + "</h3>\n<svg viewBox=\"0 0 474 " +
         text(kTall * static_cast<double>(rows.size()), "%.0f") + "\" role=\"img\" aria-label=\"" +
         escaped(title) + "\">\n" + svg + "</svg>\n<figcaption>" + escaped(sentence) +
         "</figcaption>\n</figure>\n";
}

std::string chart(const std::string& title, const Axes& axes, const std::vector<Line>& lines,
                  const std::string& sentence) {
  std::vector<double> xs, ys;
  for (const Line& line : lines) {
    for (const auto& [a, b] : line.points) {
      if (!std::isfinite(a) || !std::isfinite(b)) continue;
      xs.push_back(a);
      ys.push_back(b);
    }
  }
  std::string html = "<figure>\n<h3>" + escaped(title) + "</h3>\n";
  if (!xs.empty()) {
    const Scale x = scale_of(xs, kLeft, kRight, axes.logarithmic);
    const Scale y = scale_of(ys, kBottom, kTop, axes.logarithmic);
    std::string svg = grid(x, y, axes), keys;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::string kind = "k" + std::to_string(i) + (lines[i].is_own ? " own" : "");
      svg += drawn(lines[i], kind, x, y);
      keys +=
          "<li><svg viewBox=\"0 0 34 10\" width=\"34\" height=\"10\" aria-hidden=\"true\"><path "
          "class=\"curve " +
          kind + "\" d=\"M 1 5 H 33\"/></svg> " + escaped(lines[i].name) + "</li>";
    }
    html += "<svg viewBox=\"0 0 474 306\" role=\"img\" aria-label=\"" + escaped(title) + "\">\n" +
            svg + "</svg>\n<ul>" + keys + "</ul>\n";
  }
  return html + "<figcaption>" + escaped(sentence) + "</figcaption>\n</figure>\n";
}

}  // namespace bounce::study
