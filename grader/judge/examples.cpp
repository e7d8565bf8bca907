// Judges the cases that a student has written, on standard input, and prints JSON:
//   examples TABLE    the right and the buggy programs, as fixtures/public/wrong_programs.txt
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "../../student/given/examples/judge.hpp"

int main(int argc, char** argv) {
  using namespace bounce::examples;
  using json = nlohmann::ordered_json;
  if (argc != 2) return 2;
  using Bytes = std::istreambuf_iterator<char>;
  std::ifstream table(argv[1], std::ios::binary);
  const Judged judged = judge({Bytes(std::cin), {}}, Table({Bytes(table), {}}));
  json cases = json::array();
  for (const Verdict& verdict : judged.verdicts) {
    cases.push_back({{"place", verdict.place},
                     {"part", verdict.part},
                     {"right", verdict.is_right},
                     {"caught", verdict.caught},
                     {"message", verdict.sentence}});
  }
  std::cout << json{{"cases", cases}, {"caught", judged.caught}, {"missed", judged.missed}} << "\n";
}
