#include "compiler_words.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "files.hpp"

namespace bounce::check {
namespace {

constexpr std::size_t kLongest = 200;  // characters of a line

// ".dir/src/part1_contacts.cpp.o" in the lines of Ninja and Make; Visual Studio says nothing.
const std::regex kCompiled(R"(\.dir/(src/.*)\.o(bj)?$)");
const std::regex kVisual(R"(^ *(.*)\((\d+)(,\d+)?\) ?: (fatal )?(error|warning) \w+: (.*)$)");
const std::regex kOwnPlace(R"((^|[ \t])((src|include)/[^ :]*:\d+))");
const std::regex kError(R"(: (fatal )?error: )");
const std::regex kFromLinker("^(collect2|clang[^ ]*|ld[^ ]*): ");
const std::regex kMissing(
    "undefined reference to|Undefined symbols|undefined symbol|multiple definition of|"
    "duplicate symbol|unresolved external symbol|already defined in");

bool has(const std::string& line, const std::regex& what) { return std::regex_search(line, what); }

bool is_own(const std::string& line) {
  return line.rfind("src/", 0) == 0 || line.rfind("include/", 0) == 0;
}

// Sentences by patterns of what the compilers say.
std::vector<std::pair<std::string, std::regex>> read_meanings() {
  std::vector<std::pair<std::string, std::regex>> meanings;
  std::string sentence;
  for (const std::string& line : lines_of(read("given/check/compiler_errors.txt"))) {
    if (line.rfind("  ", 0) == 0) {
      meanings.emplace_back(sentence, std::regex(line.substr(2)));
    } else {
      sentence = line;
    }
  }
  return meanings;
}

// "YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES" as words; other texts without what says nothing.
std::string inside_a_library(std::string said) {
  said = std::regex_replace(said, std::regex("^.*error: "), "");
  said = std::regex_replace(said, std::regex("^static assertion failed:? *"), "");
  std::smatch shouted;
  if (!std::regex_search(said, shouted, std::regex("[A-Z]+_[A-Z]+_[A-Z_0-9]+"))) return said;
  std::string words = shouted.str();
  std::transform(words.begin(), words.end(), words.begin(), [](unsigned char c) {
    return c == '_' ? ' ' : static_cast<char>(std::tolower(c));
  });
  return words;
}

// "bounce::form_lcp(Eigen::Matrix<double, 3, 2, 0, 3, 2> const&, ...)" as the headers write it.
std::string with_own_types(std::string symbol) {
  static const std::pair<std::regex, std::string> kTypes[] = {
      {std::regex("Eigen::Matrix<double, 3, 1[^>]*>"), "Vector3"},
      {std::regex("Eigen::Matrix<double, 3, 2[^>]*>"), "Jacobian"},
      {std::regex("bounce::(Parameters|Lcp|Contact)"), "$1"},
      {std::regex("(\\w+) const&"), "const $1&"},
      {std::regex("`"), "'"},
  };
  for (const auto& [written, own] : kTypes) symbol = std::regex_replace(symbol, written, own);
  return symbol;
}

}  // namespace

std::vector<std::string> own_lines(const std::string& printed) {
  const std::string here = std::filesystem::current_path().generic_string() + "/";
  std::vector<std::string> lines = lines_of(printed);
  for (std::string& line : lines) {
    std::smatch visual;
    if (std::regex_match(line, visual, kVisual)) {
      std::string file = visual[1];
      std::replace(file.begin(), file.end(), '\\', '/');
      line = file + ":" + visual[2].str() + ": " + visual[5].str() + ": " + visual[6].str();
    }
    if (const std::size_t at = line.find(here); at != std::string::npos)
      line.erase(at, here.size());
  }
  return lines;
}

std::string compiled_file(const std::string& line) {
  std::smatch found;
  return std::regex_search(line, found, kCompiled) ? found[1].str() : "";
}

bool is_warning_of_own_file(const std::string& line) {
  static const std::regex kWarning(R"(^src/[^:]*:\d+:(\d+:)? warning: )");
  return has(line, kWarning);
}

bool is_missing_return(const std::string& line) {
  return line.find("[-Wreturn-type]") != std::string::npos;
}

bool is_linker_error(const std::vector<std::string>& lines) {
  const auto is_compilers = [](const std::string& line) {
    return has(line, kError) && !has(line, kFromLinker);
  };
  return std::none_of(lines.begin(), lines.end(), is_compilers) &&
         std::any_of(lines.begin(), lines.end(),
                     [](const std::string& line) { return has(line, kMissing); });
}

std::string file_of(const std::string& line) { return line.substr(0, line.find(':')); }

int line_of(const std::string& line) { return std::atoi(line.c_str() + file_of(line).size() + 1); }

std::string meaning_of(const std::vector<std::string>& lines) {
  const auto meanings = read_meanings();
  for (const std::string& line : lines) {
    if (!has(line, kError) && !has(line, kMissing)) continue;
    for (const auto& [sentence, pattern] : meanings) {
      if (has(line, pattern)) return sentence;
    }
    if (has(line, kError)) return "";  // the first error alone
  }
  return "";
}

std::string first_error(const std::vector<std::string>& lines) {
  std::string said, own, rest, missing;
  int more = 0;
  for (const std::string& line : lines) {
    std::smatch place;
    const bool leads_here = line.find("required from") != std::string::npos ||
                            line.find("instantiation of") != std::string::npos;
    if (own.empty() && (!said.empty() || leads_here) && std::regex_search(line, place, kOwnPlace)) {
      own = place[2];
    }
    if (said.empty() && has(line, kError) && !has(line, kFromLinker)) {
      said = line;
      more = 2;
      continue;
    }
    if (more-- > 0) rest += "\n  " + line.substr(0, kLongest);
    if (missing.empty() && has(line, kMissing)) {
      missing = std::regex_replace(line, std::regex(R"(^.*(\+0x\w+\): |error: |ld: ))"), "");
    }
  }
  const auto shown = [](const std::string& line) { return "  " + line.substr(0, kLongest); };
  if (!said.empty() && is_own(said)) {
    return shown(std::regex_replace(said, std::regex(R"(:\d+: (fatal )?error: )"), ": ")) + rest;
  }
  if (!said.empty()) return shown((own.empty() ? "a header" : own) + ": " + inside_a_library(said));
  if (!missing.empty()) return shown(with_own_types(missing));
  return "  the build failed; what it says is in " + (kWork / "build.txt").generic_string();
}

bool is_of_sanitizers(const std::string& line) {
  return line.rfind("==========", 0) == 0 || line.find(": runtime error: ") != std::string::npos ||
         line.find("ERROR: AddressSanitizer: ") != std::string::npos;
}

std::string found_by_sanitizers(const std::vector<std::string>& lines) {
  static const std::regex kUndefined(
      R"((^|[^/])((src|include)/[^ :]*:\d+)\S*: runtime error: (.*))");
  static const std::regex kAddress("ERROR: AddressSanitizer: ([a-zA-Z-]+)");
  std::string kind;
  for (const std::string& line : lines) {
    std::smatch found;
    if (std::regex_search(line, found, kUndefined)) {
      return "UBSan found this at " + found[2].str() + ": " + found[4].str().substr(0, kLongest);
    }
    if (kind.empty() && std::regex_search(line, found, kAddress)) kind = found[1];
    if (!kind.empty() && std::regex_search(line, found, kOwnPlace)) {
      return "AddressSanitizer found " + kind + ", at " + found[2].str();
    }
  }
  return kind.empty() ? "" : "AddressSanitizer found " + kind;
}

}  // namespace bounce::check
