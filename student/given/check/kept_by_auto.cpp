#include "kept_by_auto.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace bounce::check {
namespace {

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Where the word stands in the text, from `begin` on; npos where it doesn't.
std::size_t find_word(const std::string& text, const std::string& word, std::size_t begin = 0) {
  for (std::size_t at = text.find(word, begin); at != std::string::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins_there = at == 0 || !is_of_name(text[at - 1]);
    if (begins_there && (end == text.size() || !is_of_name(text[end]))) return at;
  }
  return std::string::npos;
}

// `auto name = value;`, or by reference.
struct Kept {
  std::string name, value;
  std::size_t at = 0;
};

std::vector<Kept> kept_by_auto(const std::string& text) {
  std::vector<Kept> all;
  for (std::size_t at = find_word(text, "auto"); at != std::string::npos;
       at = find_word(text, "auto", at + 1)) {
    const std::size_t begin = std::min(text.find_first_not_of(" &", at + 4), text.size());
    std::size_t end = begin;
    while (end < text.size() && is_of_name(text[end])) ++end;
    const std::size_t equals = std::min(text.find_first_not_of(' ', end), text.size());
    if (end == begin || equals == text.size() || text[equals] != '=') continue;
    const std::size_t stop = std::min(text.find(';', equals), text.size());
    all.push_back({text.substr(begin, end - begin), text.substr(equals, stop - equals), at});
  }
  return all;
}

// Whether the value may be an expression of Eigen that refers to a temporary value.
bool may_refer(const std::string& value) {
  const bool is_of_std = value.find("std::") == value.find_first_not_of("= ");
  return value.find('(') != std::string::npos && !is_of_std &&
         value.find("eval()") == std::string::npos && value.find('[') == std::string::npos &&
         value.find_first_of(".*+-") != std::string::npos;
}

}  // namespace

int line_of_auto(const std::string& text, int line) {
  std::size_t at = 0;
  for (int i = 1; i < line; ++i) at = text.find('\n', at) + 1;  // 0 beyond the end
  const std::size_t begin = text.find_last_of(";{}", at) + 1;
  const std::size_t end = std::min(text.find(';', at), text.size());
  std::string used = text.substr(begin, end - begin);
  std::vector<Kept> may, of_temporary;
  const std::size_t function = std::min(text.rfind("\n}", at) + 1, at);
  const std::vector<Kept> all = kept_by_auto(text.substr(function, at - function));
  for (auto kept = all.rbegin(); kept != all.rend(); ++kept) {  // one may keep another
    if (find_word(used, kept->name) == std::string::npos) continue;
    used += kept->value;
    if (may_refer(kept->value)) may.push_back(*kept);
    if (kept->value.find("M()") != std::string::npos) of_temporary.push_back(*kept);
  }
  const std::vector<Kept>& likely = of_temporary.empty() ? may : of_temporary;
  if (likely.size() != 1) return likely.empty() ? 0 : line;
  const auto kept_at = static_cast<std::ptrdiff_t>(function + likely[0].at);
  return static_cast<int>(std::count(text.begin(), text.begin() + kept_at, '\n')) + 1;
}

}  // namespace bounce::check
