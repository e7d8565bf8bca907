// recogniser FIXTURES: reads lines {"part": N, "answers": [...]}, with answers as the judge prints
// them, and prints for each {"mistakes": [name], "patterns": [sentence]}. The tests use it to
// measure the recognition of mistakes without running submissions.
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "../../tests/parts/pattern.hpp"
#include "../../tests/parts/recognise.hpp"
#include "answers_json.hpp"

namespace bounce {

static std::filesystem::path fixtures;
std::vector<std::filesystem::path> tests::fixture_folders() { return {fixtures}; }
void tests::about_to_ask(const Case&) {}
std::string tests::in_words(const Case& c, const Problem& problem) { return summary(c, problem); }

namespace {

using nlohmann::json;

struct Known {
  tests::KnownMistakes mistakes;
  std::vector<tests::Case> questions;
};

Known read(int part) {
  const auto file = tests::public_file(part, "mistakes");
  if (!file)
    throw std::runtime_error("there are no known mistakes of part " + std::to_string(part));
  std::ifstream in(*file);
  return {tests::read_mistakes(in, part), tests::questions(part)};
}

json told(int part, const Known& known, const std::vector<tests::Answer>& got) {
  json names = json::array();
  for (const auto& m : tests::recognise(known.mistakes, got)) names.push_back(m.name);
  return {{"mistakes", names},
          {"patterns", tests::patterns(part, known.questions, known.mistakes.right, got)}};
}

void serve() {
  std::map<int, Known> known;
  for (std::string line; std::getline(std::cin, line);) {
    const json asked = json::parse(line);
    const int part = asked.at("part");
    if (known.count(part) == 0) known.emplace(part, read(part));
    std::cout << told(part, known.at(part), judge::answers_of(asked.at("answers"))).dump() << "\n";
  }
}

}  // namespace
}  // namespace bounce

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: recogniser FIXTURES");
  bounce::fixtures = argv[1];
  bounce::serve();
  return 0;
} catch (const std::exception& e) {
  std::cerr << "recogniser: " << e.what() << "\n";
  return 3;
}
