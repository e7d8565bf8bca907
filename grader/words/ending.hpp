// How a program ended, and in which words that is said: by ./kit grade and by ./check.
#pragma once

#include <string>

namespace bounce::words {

// As facts. grader/judge/termination.hpp says what the course's judge finds.
struct Ending {
  std::string what;       // its id in endings.txt; or "signal", "aborted", "sanitizer"
  long number = 0;        // which belongs to it: an exit status, a signal, a limit
  std::string text = {};  // likewise; of "aborted" what the program printed last, any bytes
};

struct SaidEnding {
  std::string id;  // in endings.txt
  std::string sentence;
};

// Throws std::runtime_error for an ending that endings.txt doesn't have.
SaidEnding said(const Ending& ending);

}  // namespace bounce::words
