#include "compiler_words.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <utility>

#include "files.hpp"

namespace bounce::check {
namespace {

constexpr const char* kCrashes = "crashes.txt";
constexpr std::size_t kLongest = 200;  // characters of a line

constexpr const char* kMissing[] = {"undefined reference to", "Undefined symbols",
                                    "undefined symbol",       "multiple definition of",
                                    "duplicate symbol",       "unresolved external symbol",
                                    "already defined in"};

bool has(const std::string& line, const std::string& what) {
  return line.find(what) != std::string::npos;
}

bool begins(const std::string& line, const std::string& what) { return line.rfind(what, 0) == 0; }

bool is_own(const std::string& line) { return begins(line, "src/") || begins(line, "include/"); }

bool is_error(const std::string& line) {
  return has(line, ": error: ") || has(line, ": fatal error: ");
}

bool is_missing(const std::string& line) {
  return std::any_of(std::begin(kMissing), std::end(kMissing),
                     [&](const char* what) { return has(line, what); });
}

bool is_from_linker(const std::string& line) {
  const std::string program = line.substr(0, line.find(": "));
  return !has(program, " ") &&
         (program == "collect2" || begins(program, "clang") || begins(program, "ld"));
}

// "src/part3_step.cpp:12" if the line has that at `begin`, else empty.
std::string place_at(const std::string& line, std::size_t begin) {
  const std::size_t colon = line.find_first_of(" :", begin);
  if (colon == std::string::npos || line[colon] != ':') return "";
  const std::size_t end = std::min(line.find_first_not_of("0123456789", colon + 1), line.size());
  return end > colon + 1 ? line.substr(begin, end - begin) : "";
}

// The first place in a file of the student's that a line names, whatever stands in front of it.
std::string own_place(const std::string& line) {
  for (std::size_t at = 0; at < line.size(); ++at) {
    const bool is_own = line.compare(at, 4, "src/") == 0 || line.compare(at, 8, "include/") == 0;
    if (!is_own || (at > 0 && line[at - 1] == '/')) continue;
    if (std::string place = place_at(line, at); !place.empty()) return place;
  }
  return "";
}

// "undefined reference to `f()'", without the linker's name and the object.
std::string missing_function(const std::string& line) {
  if (has(line, "already defined in")) return line;  // behind the function's name
  for (const char* what : kMissing) {
    if (const std::size_t at = line.find(what); at != std::string::npos) return line.substr(at);
  }
  return line;
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

// With ' for the quotation marks of all compilers.
std::string plainly_quoted(std::string line) {
  for (const std::string quote : {"\u2018", "\u2019", "`", "\""}) {
    for (std::size_t at = 0; (at = line.find(quote, at)) != std::string::npos;)
      line.replace(at, quote.size(), "'");
  }
  return line;
}

// Sentences by pieces of what the compilers say.
std::vector<std::pair<std::string, std::string>> read_meanings(const std::string& file) {
  std::vector<std::pair<std::string, std::string>> meanings;
  std::string sentence;
  for (const std::string& line : lines_of(read("given/check/" + file))) {
    if (begins(line, "  ")) {
      meanings.emplace_back(sentence, line.substr(2));
    } else {
      sentence = line;
    }
  }
  return meanings;
}

std::string in_words(const std::string& kind) {
  for (const auto& [sentence, piece] : read_meanings(kCrashes)) {
    if (piece == kind) return sentence;
  }
  return kind;
}

}  // namespace

std::vector<std::string> own_lines(const std::string& printed) {
  const std::string here = std::filesystem::current_path().generic_string() + "/";
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

bool is_missing_return(const std::string& line) {
  return line.find("[-Wreturn-type]") != std::string::npos;
}

bool is_linker_error(const std::vector<std::string>& lines) {
  const auto is_compilers = [](const std::string& line) {
    return is_error(line) && !is_from_linker(line);
  };
  return std::none_of(lines.begin(), lines.end(), is_compilers) &&
         std::any_of(lines.begin(), lines.end(), is_missing);
}

std::string file_of(const std::string& line) { return line.substr(0, line.find(':')); }

int line_of(const std::string& line) { return std::atoi(line.c_str() + file_of(line).size() + 1); }

std::string meaning_of(const std::vector<std::string>& lines) {
  const auto meanings = read_meanings("compiler_errors.txt");
  for (const std::string& line : lines) {
    if (!is_error(line) && !is_missing(line)) continue;
    for (const auto& [sentence, piece] : meanings) {
      if (has(plainly_quoted(line), piece)) return sentence;
    }
    if (is_error(line)) return "";  // the first error alone
  }
  return "";
}

std::string meaning_of_assertion(const std::string& line) {
  for (const auto& [sentence, piece] : read_meanings(kCrashes)) {
    if (has(plainly_quoted(line), piece)) return sentence;
  }
  return "";
}

std::string first_error(const std::vector<std::string>& lines) {
  std::string said, own, rest, missing;
  int more = 0;
  for (const std::string& line : lines) {
    const bool leads_here = line.find("required from") != std::string::npos ||
                            line.find("instantiation of") != std::string::npos;
    if (own.empty() && (!said.empty() || leads_here)) own = own_place(line);
    if (said.empty() && is_error(line) && !is_from_linker(line)) {
      said = line;
      more = 2;
      continue;
    }
    if (more-- > 0) rest += "\n  " + line.substr(0, kLongest);
    if (missing.empty() && is_missing(line)) missing = missing_function(line);
  }
  const auto shown = [](const std::string& line) { return "  " + line.substr(0, kLongest); };
  if (!said.empty() && is_own(said)) {
    return shown(own_place(said) + ": " + said.substr(said.find("error: ") + 7)) + rest;
  }
  if (!said.empty())
    return shown((own.empty() ? "a header" : own) + ": " + said.substr(said.find("error: ") + 7));
  if (!missing.empty()) return shown(missing);
  return "  the build failed; what it says is in " + (kWork / "build.txt").generic_string();
}

std::string place_in_sources(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (const std::string place = own_place(line); begins(place, "src/")) return place;
  }
  return "";
}

std::string found_by_sanitizers(const std::vector<std::string>& lines) {
  const std::string undefined = ": runtime error: ", address = "ERROR: AddressSanitizer: ";
  std::string kind;
  for (const std::string& line : lines) {
    if (const std::size_t at = line.find(undefined); at != std::string::npos) {
      const std::string place = own_place(line.substr(0, at));
      const std::string what = line.substr(at + undefined.size(), kLongest);
      if (!place.empty()) return place + ": " + what;
    }
    if (const std::size_t at = line.find(address); kind.empty() && at != std::string::npos) {
      kind = line.substr(at + address.size());
      kind.erase(std::min(kind.find_first_of(" :("), kind.size()));
    }
    const std::string place = kind.empty() ? "" : own_place(line);
    if (!place.empty()) return place + ": " + in_words(kind);
  }
  return kind.empty() ? "" : in_words(kind);
}

}  // namespace bounce::check
