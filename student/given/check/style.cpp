#include "style.hpp"

#include <cstdlib>

#include "process.hpp"

namespace bounce::check {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool has_utf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const std::string value = variable(name);
    if (value.empty()) continue;
    for (const char* utf8 : {"UTF-8", "utf-8", "UTF8", "utf8"}) {
      if (value.find(utf8) != std::string::npos) return true;
    }
    return false;
  }
  return false;
}

Style made() {
#ifdef _WIN32
  const bool dumb = false, signs = is_terminal();
#else
  const bool dumb = variable("TERM").empty() || variable("TERM") == "dumb", signs = has_utf8();
#endif
  Style made{"", "", "", "", "", signs ? "\u2713" : "ok", signs ? "\u2717" : "--"};
  if (is_terminal() && !dumb && variable("NO_COLOR").empty()) {
    made.bold = "\033[1m";
    made.red = "\033[31m";
    made.green = "\033[32m";
    made.dim = "\033[2m";
    made.plain = "\033[0m";
  }
  return made;
}

}  // namespace

const Style& style() {
  static const Style the = made();
  return the;
}

}  // namespace bounce::check
