// auto_line LINE < SOURCE: says, as ./check does, which `auto` keeps what that line uses when it is
// gone: "12 `auto` keeps ...", or nothing where none does. It runs in a box, since the source is a
// submission's.
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>

#include "../../student/given/check/kept_by_auto.hpp"

int main(int count, char** words) {
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const int line = bounce::check::line_of_auto(text, count > 1 ? std::atoi(words[1]) : 0);
  if (line != 0) std::cout << line << ' ' << bounce::check::kAutoKeeps;
}
