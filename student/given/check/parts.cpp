#include "parts.hpp"

#include "files.hpp"

namespace bounce::check {

std::vector<Part> read_parts() {
  std::vector<Part> parts;
  for (const std::string& line : lines_of(read("tests/checks.txt"))) {
    const std::vector<std::string> cells = split(line, '\t');
    if (cells.size() >= 5 && cells[0] == "part") {
      parts.push_back(
          {std::stoi(cells[1]), cells[2], cells[4], std::stoi(cells[3]), {}, {}, "notes"});
      if (cells.size() == 6) {
        for (const std::string& n : split(cells[5], ' '))
          parts.back().calls.push_back(std::stoi(n));
      }
    } else if (cells.size() == 4 && !parts.empty()) {
      parts.back().checks.push_back({cells[1], cells[3], std::stoi(cells[2])});
    }
  }
  if (parts.empty()) throw Failure("tests/checks.txt is missing: unpack the handout anew");
  return parts;
}

}  // namespace bounce::check
