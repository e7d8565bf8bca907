#include "ending.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <sstream>

#include "compiler_words.hpp"
#include "files.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

#ifdef SIGXCPU
constexpr int kWorkedTooLong = SIGXCPU;
#else
constexpr int kWorkedTooLong = -1;
#endif

// The last line in which a program says why it stops.
std::string last_reason(const std::string& printed) {
  std::string last;
  for (const std::string& line : lines_of(printed)) {
    const bool says =
        line.find("Assertion") != std::string::npos || line.find("what():") != std::string::npos;
    if (says) last = printable(line);
  }
  return last;
}

std::string why_aborted(const std::string& said) {
  static const std::string kAborted = "the program was aborted: ";
  if (const std::size_t at = said.find("what():"); at != std::string::npos) {
    return "the program threw an exception: " + said.substr(said.find_first_not_of(' ', at + 7)) +
           ", and nobody caught it";
  }
  if (const std::string meaning = meaning_of_assertion(said); !meaning.empty()) {
    const std::size_t type = std::min(said.find("Eigen::Matrix<double, "), said.size());
    int rows = 0, columns = 0;
    std::sscanf(said.c_str() + type, "Eigen::Matrix<double, %d, %d", &rows, &columns);
    const std::string size = std::to_string(rows) + "x" + std::to_string(columns);
    return kAborted + meaning + (rows > 0 && columns > 0 ? " (a " + size + " matrix)" : "");
  }
  if (const std::size_t at = said.find("Assertion"); at != std::string::npos) {
    return kAborted + "a failed assertion: " + said.substr(at + 9).substr(0, 100);
  }
  return kAborted + "a failed assertion, or an exception nobody caught";
}

}  // namespace

std::string place_of_crash(const std::string& program, const fs::path& stack) {
#ifdef __APPLE__
  std::vector<std::string> command{"atos", "-fullPath", "-o", program};
#else
  std::vector<std::string> command{"addr2line", "-e", program};
#endif
  std::istringstream words(read(stack));
  for (std::string word; words >> word;) {
    if (word.rfind("0x", 0) == 0) command.push_back(word);
  }
  if (command.back().rfind("0x", 0) != 0) return "";
  fs::remove(stack);
  check::run(command, stack, Limits::none);
  const std::string place = place_in_sources(own_lines(read(stack)));
  return place.empty() ? "" : ", at " + place;
}

std::string reason_of(const Termination& ended, const std::string& printed) {
  if (const std::string found = found_by_sanitizers(own_lines(printed)); !found.empty()) {
    return found;
  }
  if (ended.signal == kPrintedTooMuch) return "the program printed without end";
  if (ended.signal == kWorkedTooLong) return "the program worked without end: an endless loop?";
  switch (ended.signal) {
    case 0:
      break;
    case SIGABRT:
      return why_aborted(last_reason(printed));
    case SIGFPE:
      return "the program crashed: a division by zero";
#ifdef SIGBUS
    case SIGBUS:
#endif
    case SIGSEGV:
      return "the program crashed: an index or a pointer out of bounds, or recursion without end";
    case SIGILL:
      return "the program crashed: is a return missing?";
#ifdef SIGKILL
    case SIGKILL:
      return "the program was ended, perhaps for want of memory";
#endif
    default:
      return "the program was ended by signal " + std::to_string(ended.signal);
  }
  if (ended.code == kTooLong) return "no answer within 3 s of work: an endless loop?";
  return "the program ended by itself, with status " + std::to_string(ended.code) +
         ": does it call exit?";
}

}  // namespace bounce::check
