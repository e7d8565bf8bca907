#include "page.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "paths.hpp"

namespace bounce::study {
namespace {

constexpr const char* kStyle = R"css(
:root { color-scheme: light dark; --ink: #1f2430; --paper: #ffffff; }
@media screen and (prefers-color-scheme: dark) { :root { --ink: #e8e6e1; --paper: #14181f; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem 1.2rem 4rem; max-width: 92rem; color: var(--ink);
  background: var(--paper); font: 1rem/1.55 system-ui, sans-serif; }
p { max-width: 46rem; }
.note { border-left: 4px solid var(--b); padding-left: 0.8rem; }
section { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr));
  gap: 1rem 2.5rem; }
figure { margin: 0; max-width: 40rem; }
h3 { margin: 0.8rem 0 0.3rem; font-size: 1.05em; }
figure > svg { width: 100%; height: auto; }
text { fill: var(--ink); font: 13px system-ui, sans-serif; }
.bar { fill: none; stroke: var(--e); }
.bar.own { fill: var(--a); stroke: var(--a); }
ul { display: flex; flex-wrap: wrap; gap: 0 1.2rem; margin: 0.2rem 0; padding: 0; list-style: none;
  font-size: 0.9em; }
figcaption { margin: 0.3rem 0 0.8rem; }
@media (max-width: 640px), print { text { font-size: 18px; } }
@media print { :root { color-scheme: light; } body { font-size: 10pt; }
  section { grid-template-columns: 1fr 1fr; } main > figure { max-width: 24rem; }
  figure { break-inside: avoid; } }
)css";

std::string style() {
  std::ifstream in(std::filesystem::path(BOUNCE_CHART_STYLE));
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error("given/study/chart.css is missing: unpack the handout anew");
  return text.str() + kStyle;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) html += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return html;
}

std::string page(const std::string& title, const std::string& note, const std::string& body) {
  const std::string head = escaped(title);
  return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         head + "</title>\n<style>" + style() + "</style>\n</head>\n<body>\n<main>\n<h1>" + head +
         "</h1>\n" + (note.empty() ? "" : "<p class=\"note\">" + escaped(note) + "</p>\n") + body +
         "</main>\n</body>\n</html>\n";
}

void write_page(const std::filesystem::path& file, const std::string& html) {
  if (!(std::ofstream(file, std::ios::binary) << html).flush()) {
    throw std::runtime_error(file.string() + " can't be written");
  }
}

}  // namespace bounce::study
