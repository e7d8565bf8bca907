// Reads tables.txt, which says what its lines are.
#include <sstream>
#include <utility>

#include "findings.hpp"

namespace bounce::tests {
namespace {

constexpr std::size_t kIndent = 11;  // of what a line says
constexpr const char* kTable =
#include "tables.txt"
    ;

// "a0 = r3; a1 = r0; ..." for the places "3 0 ...".
std::string as_numbers(const std::string& places) {
  std::string numbers;
  std::istringstream all(places);
  int number = 0;
  for (std::string place; all >> place; ++number)
    numbers += (number > 0 ? "; a" : "a") + std::to_string(number) + " = r" + place;
  return numbers;
}

std::map<std::string, std::vector<Row>> read_table() {
  std::map<std::string, std::vector<Row>> parts;
  std::string part, *last = nullptr;
  bool begins = true;
  std::istringstream table(kTable);
  for (std::string line; std::getline(table, line);) {
    const std::string name = line.substr(0, line.find(' '));
    const std::string text = line.substr(std::min(kIndent, line.size()));
    if (line.empty()) {
      begins = true;
    } else if (line[0] == '#') {  // a comment
      continue;
    } else if (name == "part") {
      part = text;
    } else if (name.empty()) {
      *last += " " + text;
    } else {
      if (std::exchange(begins, false)) parts[part].emplace_back();
      Row& row = parts[part].back();
      last = &(row[name] = text);
      if (name == "places") row["numbers"] = as_numbers(text);
    }
  }
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t from = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(from, text.find_last_not_of(' ') + 1 - from);
}

}  // namespace

const std::vector<Row>& rows_of(const std::string& part) {
  static auto parts = read_table();
  return parts[part];  // none of a part that isn't in the table
}

std::string text_of(const Row& row, const std::string& name) {
  const auto line = row.find(name);
  return line == row.end() ? "" : line->second;
}

Words split(const std::string& list, char between) {
  Words all;
  std::istringstream texts(list);
  for (std::string text; std::getline(texts, text, between);) all.push_back(trimmed(text));
  return all;
}

std::vector<Alternative> alternatives(const std::string& list) {
  const std::string named = text_of(rows_of("lists")[0], list);
  std::vector<Alternative> all;
  for (const std::string& text : split(named.empty() ? list : named)) {
    const std::size_t at = text.find(":=");
    all.push_back(at == text.npos ? Alternative{text, text}
                                  : Alternative{trimmed(text.substr(0, at)), text.substr(at + 2)});
  }
  return all;
}

}  // namespace bounce::tests
