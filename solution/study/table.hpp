// One table of a study, written as CSV with comma and a header line.
#pragma once

#include <concepts>
#include <string>
#include <vector>

#include "../exact/scene.hpp"
#include "timing.hpp"

namespace bounce::study {

class Table {
 public:
  explicit Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}

  // A row: as many values as there are columns; throws std::logic_error otherwise.
  template <class... Values>
  void add(const Values&... values) {
    add_row({text(values)...});
  }

  // Lines that begin with # come first: machine, compiler, flags and date. Throws
  // std::runtime_error if the file can't be written whole.
  void write(const std::string& file, const std::vector<std::string>& origin) const;

 private:
  static std::string text(const std::string& value) { return value; }
  static std::string text(double value) { return text_of(value, 5); }
  static std::string text(std::integral auto value) { return std::to_string(value); }  // bool: 1, 0
  void add_row(std::vector<std::string> row);

  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

// Where the numbers come from: "# machine: ...", and so on; "# times: ..." if there are any.
std::vector<std::string> origin(const std::string& times = "");

// How times are taken: on the core that the process is pinned to, or -1.
std::string times_taken(int core, const Extent& extent);
std::string times_taken(int core);  // for a table of many scenes, each run once

}  // namespace bounce::study
