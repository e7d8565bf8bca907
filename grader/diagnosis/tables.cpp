// Reads tables.txt, which says what its lines are.
#include "tables.hpp"

#include <sstream>
#include <utility>

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

std::map<std::string, std::vector<Row>>& tables() {
  static auto parts = read_table();
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t from = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(from, text.find_last_not_of(' ') + 1 - from);
}

}  // namespace

const std::vector<Row>& rows_of(const std::string& part) {
  return tables()[part];  // none of a part that isn't in the table
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
    const std::size_t end_of_id = text[0] == '[' ? text.find(']') + 1 : 0;
    const std::string id = end_of_id > 0 ? text.substr(1, end_of_id - 2) : "";
    const std::string rest = trimmed(text.substr(end_of_id));
    const std::size_t at = rest.find(":=");
    all.push_back(at == rest.npos
                      ? Alternative{id, rest, rest}
                      : Alternative{id, trimmed(rest.substr(0, at)), rest.substr(at + 2)});
  }
  return all;
}

std::string joined(const Words& words, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
  }
  return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string sentence_of(const Pattern& pattern) {
  static const std::map<std::string, std::string> sentences = [] {
    std::map<std::string, std::string> all;
    for (const auto& [part, rows] : tables()) {
      for (const Row& row : rows) {
        if (row.count("id") > 0) all[row.at("id")] = row.at("say");
      }
    }
    return all;
  }();
  std::string text = sentences.at(pattern.id);
  for (std::size_t i = 0; i < pattern.words.size(); ++i) {
    if (i == 0) text = replaced(text, "{}", pattern.words[0]);
    text = replaced(text, "{" + std::to_string(i) + "}", pattern.words[i]);
  }
  return text;
}

}  // namespace bounce::tests
