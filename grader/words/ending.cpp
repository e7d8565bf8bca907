#include "ending.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "sentences.hpp"

namespace bounce::words {
namespace {

const std::string kEndings = "endings.txt", kCrashes = "crashes.txt";

// Names of signals, which have other numbers on other systems.
std::string name_of(long signal) {
  static const std::vector<std::pair<long, const char*>> kNames = {
      {SIGSEGV, "SIGSEGV"}, {SIGABRT, "SIGABRT"}, {SIGFPE, "SIGFPE"},   {SIGILL, "SIGILL"},
      {SIGTERM, "SIGTERM"},
#ifndef _WIN32
      {SIGBUS, "SIGBUS"},   {SIGSYS, "SIGSYS"},   {SIGTRAP, "SIGTRAP"}, {SIGXFSZ, "SIGXFSZ"},
      {SIGKILL, "SIGKILL"}, {SIGPIPE, "SIGPIPE"}, {SIGALRM, "SIGALRM"}, {SIGHUP, "SIGHUP"},
      {SIGINT, "SIGINT"},   {SIGQUIT, "SIGQUIT"}, {SIGUSR1, "SIGUSR1"}, {SIGUSR2, "SIGUSR2"},
#endif
  };
  for (const auto& [number, name] : kNames) {
    if (number == signal) return name;
  }
  return std::to_string(signal);
}

// What follows the last `mark`, to the end of its line; empty if there is none.
std::string after_last(const std::string& text, const std::string& mark) {
  const std::size_t at = text.rfind(mark);
  if (at == std::string::npos) return "";
  return text.substr(at + mark.size(), text.find('\n', at) - at - mark.size());
}

// "File.h:12" of the first "File.h:12: " in a line, which may be very long.
std::string place_in(const std::string& line) {
  const std::string digits = "0123456789", letters = "abcdefghijklmnopqrstuvwxyz";
  const std::string in_names = letters + "ABCDEFGHIJKLMNOPQRSTUVWXYZ_.+-" + digits;
  for (std::size_t at = line.find(':'); at != std::string::npos; at = line.find(':', at + 1)) {
    const std::size_t end = line.find_first_not_of(digits, at + 1);
    if (end == at + 1 || end == std::string::npos || line.compare(end, 2, ": ") != 0) continue;
    const std::size_t before = at == 0 ? at : line.find_last_not_of(in_names, at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    if (begin < at) return line.substr(begin, std::min<std::size_t>(end - begin, 120));
  }
  return "";
}

// The condition of a failed assertion in a line as glibc prints it, "program: path/File.h:12:
// function: Assertion `words' failed.", and behind it its file and line; or as macOS and Windows
// do, "Assertion failed: words, file ...". Empty if the line tells of none.
std::pair<std::string, std::string> assertion_in(const std::string& line) {
  static const std::string kAssertion = "Assertion ", kOthers = "failed: ", kEnd = "' failed";
  const std::size_t at = line.find(kAssertion);
  if (at == std::string::npos) return {};
  const std::string before = line.substr(0, at), after = line.substr(at + kAssertion.size());
  if (after.rfind(kOthers, 0) == 0) return {after.substr(kOthers.size()), "an assertion"};
  const std::size_t end = after.rfind(kEnd);
  const bool is_quoted = !after.empty() && (after[0] == '`' || after[0] == '\'');
  if (!is_quoted || end == std::string::npos || end == 0) return {};
  const std::string place = place_in(before);
  if (place.empty()) return {};
  return {after.substr(1, end - 1), place};
}

// "(a 3x2 matrix)", of which Eigen's assertions are a function's; empty for other lines. -1 columns
// are as many as the program says.
std::string shape_in(const std::string& line) {
  const std::size_t type = std::min(line.find("Eigen::Matrix<double, "), line.size());
  int rows = 0, columns = 0;
  std::sscanf(line.c_str() + type, "Eigen::Matrix<double, %d, %d", &rows, &columns);
  if (rows > 0 && columns == -1) {
    const std::string number = std::to_string(rows);
    return " (a matrix that is " + number + "x0 until it is given a size, as in Eigen::Matrix" +
           number + "Xd q(" + number + ", params.T))";
  }
  if (rows <= 0 || columns <= 0) return "";
  return " (a " + std::to_string(rows) + "x" + std::to_string(columns) + " matrix)";
}

std::string why_it_threw(const std::string& printed) {
  const std::string type = after_last(printed, "terminate called after throwing an instance of '");
  const std::string what = after_last(printed, "  what():  ");
  if (type.empty()) return one_line(after_last(printed, "uncaught exception of type "));
  const std::string quoted = what.empty() ? "" : ", \"" + one_line(what) + "\"";
  return one_line(type.substr(0, type.find('\''))) + quoted;
}

// What glibc says where it finds that its data about memory were overwritten.
bool is_about_memory(const std::string& line) {
  for (const char* words : {"free(): ", "malloc(): ", "realloc(): ", "malloc_consolidate(): ",
                            "munmap_chunk(): ", "double free or corruption", "corrupted size",
                            "corrupted double-linked", "stack smashing detected"}) {
    if (line.find(words) != std::string::npos) return true;
  }
  return false;
}

// "a product whose ..., (a 3x2 matrix)" for the line of a failed assertion, or its place and
// condition where the meaning isn't known.
std::string meaning_of_assertion(const std::string& line) {
  const auto [condition, place] = assertion_in(line);
  const std::string meaning = meaning_in(kCrashes, condition);
  return meaning.empty() ? place + ": " + one_line(condition) : meaning + shape_in(line);
}

// The id in endings.txt, and the text in its sentence.
std::pair<std::string, std::string> id_and_text_of(const Ending& ending) {
  if (ending.what == "assertion") return {ending.what, meaning_of_assertion(ending.text)};
  if (ending.what == "sanitizer") {
    const std::string meaning = sentence_of(kCrashes, ending.text);
    if (!meaning.empty()) return {"found", meaning};
  } else if (ending.what != "signal") {
    return {ending.what, ending.text};
  }
  const std::string name = name_of(ending.number);
  const std::string cause = ending.text.empty() ? "early" : ending.text;
  for (const std::string& id : {name + " " + cause, name}) {
    if (!sentence_of(kEndings, id).empty()) return {id, name};
  }
  return {"signal", name};
}

}  // namespace

Ending of_abort(const std::string& printed) {
  std::istringstream lines(printed);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (!assertion_in(line).first.empty()) return {"assertion", SIGABRT, line};
    if (!line.empty()) last = line;
  }
  const std::string threw = why_it_threw(printed);
  if (!threw.empty()) return {"threw", SIGABRT, threw};
  last = one_line(last);
  return {is_about_memory(last) ? "overwrote" : "aborted", SIGABRT, last};
}

std::string said(const Ending& ending) {
  const auto [id, text] = id_and_text_of(ending.what == "aborted" ? of_abort(ending.text) : ending);
  const std::string sentence = sentence_of(kEndings, id), number = std::to_string(ending.number);
  if (sentence.empty()) throw std::runtime_error("endings.txt has no sentence for " + id);
  const bool is_start = text == "clone" || text == "fork" || text == "vfork";  // not of a thread
  const std::string call = "the system call " + (text.empty() ? number : text);
  return filled(sentence,
                {{"text", text},
                 {"number", number},
                 {"came", text.empty() ? "no answer came" : "only part of an answer came"},
                 {"call", is_start ? "to start a process" : call}});
}

}  // namespace bounce::words
