#include "words.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "files.hpp"
#include "sentences.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

constexpr const char* kErrors = "../check/compiler_errors.txt";
constexpr int kSecondsOfAnAnswer = 3;  // tests/linked/time_limit.cpp
constexpr std::size_t kLongest = 200;  // characters of a line
bool is_own(const std::string& line) { return begins(line, "src/") || begins(line, "include/"); }

// Of the compiler, and not of the linker.
bool is_error(const std::string& line) {
  const bool is_linkers = begins(line, "collect2: ") || begins(line, "clang") || begins(line, "ld");
  return !is_linkers && (has(line, ": error: ") || has(line, ": fatal error: "));
}

// "undefined reference to `f()'", without the linker's name and the object, where a function is
// missing or there twice; else empty.
std::string missing_function(const std::string& line) {
  if (has(line, "already defined in")) return line;  // behind the function's name
  for (const char* what :
       {"undefined reference to", "Undefined symbols", "undefined symbol",
        "unresolved external symbol", "multiple definition of", "duplicate symbol"}) {
    if (has(line, what)) return line.substr(line.find(what));
  }
  return "";
}

// "src/part3_step.cpp:12": the first place in a file of the student's that a line names, whatever
// stands in front of it; empty if there is none.
std::string own_place(const std::string& line) {
  for (std::size_t at = 0; at < line.size(); ++at) {
    const bool is_own = line.compare(at, 4, "src/") == 0 || line.compare(at, 8, "include/") == 0;
    if (!is_own || (at > 0 && line[at - 1] == '/')) continue;
    const std::size_t colon = std::min(line.find_first_of(" :", at), line.size());
    const std::size_t end = std::min(line.find_first_not_of("0123456789", colon + 1), line.size());
    if (line[colon] == ':' && end > colon + 1) return line.substr(at, end - at);
  }
  return "";
}

// "file.cpp(12,3): error C2065: what" of Visual C++ as others write it; other lines as they are.
std::string as_others_write(const std::string& line) {
  for (const std::string kind : {"error", "warning"}) {
    const std::size_t at =
        std::min(line.find(": " + kind + " "), line.find(": fatal " + kind + " "));
    if (at == std::string::npos) continue;
    const std::size_t open = line.rfind('(', at), what = line.find(": ", at + 2);
    if (open == std::string::npos || what == std::string::npos) continue;
    const int number = std::atoi(line.c_str() + open + 1);
    if (number == 0 || line.find(')', open) > at) continue;
    std::string file = line.substr(0, open);
    file.erase(0, file.find_first_not_of(' '));
    std::replace(file.begin(), file.end(), '\\', '/');
    return file + ":" + std::to_string(number) + ": " + kind + line.substr(what);
  }
  return line;
}

}  // namespace

std::vector<std::string> own_lines(const std::string& printed) {
  const std::string here = fs::current_path().generic_string() + "/";
  std::vector<std::string> lines = lines_of(printed);
  for (std::string& line : lines) {
    line = as_others_write(line);
    if (const std::size_t at = line.find(here); at != std::string::npos)
      line.erase(at, here.size());
  }
  return lines;
}

bool is_warning_of_own_file(const std::string& line) {
  return begins(line, "src/") && has(line, ": warning: ") &&
         line.find(": ") == line.find(": warning: ");
}

std::string file_of(const std::string& line) { return line.substr(0, line.find(':')); }

int line_of(const std::string& line) { return std::atoi(line.c_str() + file_of(line).size() + 1); }

BuildError first_error(const std::vector<std::string>& lines) {
  std::string error, own, rest, missing;
  int more = 0;
  for (const std::string& line : lines) {
    const bool leads_here = has(line, "required from") || has(line, "instantiation of");
    if (own.empty() && (!error.empty() || leads_here)) own = own_place(line);
    if (error.empty() && is_error(line)) {
      error = line;
      more = 2;
      continue;
    }
    if (more-- > 0) rest += "\n  " + line.substr(0, kLongest);
    if (missing.empty()) missing = missing_function(line);
  }
  if (error.empty() && missing.empty()) {
    const std::string where = (kWork / "build.txt").generic_string();
    const std::string failed = "the build failed; what it says is in " + where;
    return {"  " + failed, failed};
  }
  std::string text = missing;
  if (!error.empty()) {
    text = (is_own(error) ? own_place(error)
            : own.empty() ? "a header"
                          : own) +
           ": " + error.substr(error.find("error: ") + 7);
  }
  text = text.substr(0, kLongest);
  const std::string meaning = words::meaning_in(kErrors, error.empty() ? missing : error);
  const bool is_clear = meaning.empty();
  return {"  " + text + (is_own(error) ? rest : "") +
              (is_clear ? "" : "\n" + folded(meaning, 74, "  ")),
          text + (is_clear ? "" : ". " + meaning),
          is_own(error) ? error.substr(0, error.find(": ")) : own};
}

std::string found_by_sanitizers(const std::string& printed) {
  const std::string undefined = ": runtime error: ", address = "ERROR: AddressSanitizer: ";
  std::string found;
  for (const std::string& line : own_lines(printed)) {
    if (const std::size_t at = line.find(undefined); at != std::string::npos) {
      const std::string place = own_place(line.substr(0, at));
      if (!place.empty()) return place + ": " + line.substr(at + undefined.size(), kLongest);
    }
    if (const std::size_t at = line.find(address); found.empty() && at != std::string::npos) {
      const std::string kind = line.substr(at + address.size());
      found = kind.substr(0, kind.find_first_of(" :("));
      if (const std::string meaning = words::meaning_in("crashes.txt", found); !meaning.empty())
        found = meaning;
    }
    const std::string place = found.empty() ? "" : own_place(line);
    if (!place.empty()) return place + ": " + found;
  }
  return found;
}

std::string place_of_crash(const std::string& program, const fs::path& stack) {
#ifdef __APPLE__
  std::vector<std::string> command{"atos", "-fullPath", "-o", program};
#else
  std::vector<std::string> command{"addr2line", "-e", program};
#endif
  std::istringstream words(read(stack));
  for (std::string word; words >> word;) {
    if (begins(word, "0x")) command.push_back(word);
  }
  if (!begins(command.back(), "0x")) return "";
  fs::remove(stack);
  check::run(command, stack, Limits::none);
  for (const std::string& line : own_lines(read(stack))) {
    if (const std::string place = own_place(line); begins(place, "src/")) return place;
  }
  return "";
}

std::string cause_in(const fs::path& stack) {
  const std::string said = read(stack), mark = "cause of the crash: ";
  const std::size_t at = said.find(mark);
  if (at == std::string::npos) return "unknown";
  return said.substr(at + mark.size(), said.find('\n', at) - at - mark.size());
}

words::Ending ending_of(int ended, const std::string& printed, const std::string& cause) {
  if (ended == -SIGXCPU) return {"worked", kSecondsOfWork};
  if (ended == kTooLong) return {"worked", kSecondsOfAnAnswer};
  if (ended == kWaited) return {"waited"};
  if (ended == -SIGXFSZ) return {"printed", kLargestFile / 1'000'000};
  if (ended >= 0) return {"exited", ended};
  if (ended != -SIGABRT) return {"signal", -ended, cause};
  std::string lines;
  for (const std::string& line : lines_of(printed)) lines += printable(line) + "\n";
  return words::of_abort(lines);
}

std::string reason_of(int ended, const std::string& printed, const std::string& cause) {
  const std::string found = found_by_sanitizers(printed);
  return found.empty() ? words::said(ending_of(ended, printed, cause)) : found;
}

}  // namespace bounce::check
