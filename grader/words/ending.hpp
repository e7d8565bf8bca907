// How a program ended, and in which words that is said: by ./kit grade and by ./check.
#pragma once

#include <string>

namespace bounce::words {

// As facts. grader/judge/termination.hpp says what the course's judge finds.
struct Ending {
  std::string what;       // its id in endings.txt; or "signal", or "sanitizer"
  long number = 0;        // which belongs to it: an exit status, a signal, a limit
  std::string text = {};  // likewise; what sanitizers or an exception say, an assertion's line
};

// Why a program aborted that had printed this last, which may be any bytes: "assertion", "threw",
// "overwrote" or "aborted".
Ending of_abort(const std::string& printed);

// Throws std::runtime_error for an ending that endings.txt doesn't have.
std::string said(const Ending& ending);

}  // namespace bounce::words
