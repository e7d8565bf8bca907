#include "hints.hpp"

#include <algorithm>
#include <fstream>

namespace bounce::words {
namespace {

using Names = std::vector<std::string>;

struct Section {
  Hint hint;
  Names checks, diagnoses, numbers;
};

// What stands between the separators, behind the label; empty if the line has another one.
Names listed(const std::string& line, const std::string& label, const std::string& separator) {
  Names all;
  if (line.rfind(label, 0) != 0) return all;
  for (std::size_t from = label.size(); from < line.size();) {
    const std::size_t end = std::min(line.find(separator, from), line.size());
    all.push_back(line.substr(from, end - from));
    from = end + separator.size();
  }
  return all;
}

void add(Names& names, const Names& more) { names.insert(names.end(), more.begin(), more.end()); }

std::vector<Section> sections_of(const std::string& stem) {
  std::vector<Section> all;
  std::ifstream page(hints_folder / (stem + ".md"));
  bool is_nudge = false;
  for (std::string line; std::getline(page, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.rfind("## ", 0) == 0) all.push_back({{line.substr(3), ""}, {}, {}, {}});
    if (all.empty() || line.empty()) continue;
    Section& section = all.back();
    add(section.checks, listed(line, "Checks: ", ", "));
    add(section.diagnoses, listed(line, "Diagnoses: ", "; "));
    add(section.numbers, listed(line, "Numbers: ", "; "));
    if (is_nudge) {
      line.erase(std::remove(line.begin(), line.end(), '`'), line.end());
      section.hint.nudge = line;
    }
    is_nudge = line == "### A nudge";
  }
  return all;
}

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "where(l)" of each thing that it is about, or its id alone.
Names names_of(const Pattern& pattern) {
  Names names{pattern.id};
  for (const std::string& about : pattern.about) names.push_back(pattern.id + "(" + about + ")");
  return names;
}

}  // namespace

Hint hint_of(const std::string& stem, const std::string& check,
             const std::vector<Pattern>& patterns) {
  const std::vector<Section> sections = sections_of(stem);
  for (const Pattern& pattern : patterns) {
    for (const std::string& name : names_of(pattern)) {
      for (const Section& section : sections) {
        const bool is_own = has(section.checks, check) && has(section.numbers, name);
        if (is_own || has(section.diagnoses, name)) return section.hint;
      }
    }
  }
  for (const Section& section : sections) {
    if (has(section.checks, check)) return section.hint;
  }
  return {};
}

Hint hint_named(const std::string& stem, const std::string& heading) {
  for (const Section& section : sections_of(stem)) {
    if (section.hint.heading == heading) return section.hint;
  }
  return {};
}

}  // namespace bounce::words
