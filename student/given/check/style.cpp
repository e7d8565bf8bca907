#include "style.hpp"

#include <cstdlib>

#include "process.hpp"

namespace bounce::check {

const Style& style() {
  const auto is_set = [](const char* name, const std::string& to) {
    const char* value = std::getenv(name);
    return value && (to.empty() ? *value : value == to);
  };
  static const Style plain{}, coloured{"\033[1m", "\033[31m", "\033[32m", "\033[2m", "\033[0m"};
  static const bool has_colours =
      is_terminal() && !is_set("TERM", "dumb") && !is_set("NO_COLOR", "");
  return has_colours ? coloured : plain;
}

}  // namespace bounce::check
