// slips FIXTURES PAIRS: prints what is said of each program of the styles with one slip, and with
// two of PAIRS random pairs for each style and part, as lines {"part": N, "style": "loop", "slips":
// ["..."], "right": false, "mistakes": ["part1_..."], "patterns": ["..."]}. table.py reads them.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "../../../parts/answers.hpp"
#include "../../../parts/pattern.hpp"
#include "../../../parts/recognise.hpp"
#include "../../../parts/submission.hpp"
#include "part1.hpp"
#include "part2.hpp"
#include "part3.hpp"
#include "whole_styles.hpp"

namespace bounce {

static std::filesystem::path fixtures;
std::vector<std::filesystem::path> tests::fixture_folders() { return {fixtures}; }
void tests::about_to_ask(const Case&) {}
std::string tests::in_words(const Case& c, const Problem& problem) { return summary(c, problem); }

}  // namespace bounce

namespace slips {

Program& program() {
  static Program running;
  return running;
}

namespace {

using namespace bounce::tests;
using Slips = std::set<std::string, std::less<>>;

// Styles in which all parts are written.
const std::map<std::string, const Style*>& whole_styles() {
  static const std::map<std::string, const Style*> styles{{"helper class", &classes()},
                                                          {"contact frame", &contact_frame()}};
  return styles;
}

// A part's function in one of its own styles, or in one of whole programs.
template <typename Function>
Function in_style(const std::map<std::string, Function>& styles, const std::string& style,
                  Function Style::*part) {
  const auto whole = whole_styles().find(style);
  return whole == whole_styles().end() ? styles.at(style) : whole->second->*part;
}

Eigen::VectorXd asked(int part, const std::string& style, const Case& c) {
  if (part == 1) {
    return numbers_of(in_style(part1_styles(), style, &Style::get_contacts)(c.q, c.params));
  }
  if (part == 2) {
    return numbers_of(in_style(part2_styles(), style, &Style::form_lcp)(c.J, c.v, c.params));
  }
  if (part == 3) {
    return numbers_of(in_style(part3_styles(), style, &Style::step)(c.q, c.v, c.params), c);
  }
  const auto simulate = in_style(part4_styles(), style, &Style::simulate);
  const Trajectory path = simulate(c.q, c.v, c.params);
  submission::require_columns(path.q.cols(), path.v.cols(), c.params.T);
  return numbers_of(path);
}

struct Run {
  std::vector<Answer> answers;
  Slips asked;  // that the program could hold
};

Run run(int part, const std::string& style, const std::vector<Case>& cases, const Slips& slips) {
  program() = Program{slips, {}, {}, {}};
  Run found;
  for (const Case& c : cases) {
    try {
      found.answers.push_back({asked(part, style, c), ""});
    } catch (const std::exception& thrown) {
      found.answers.push_back({{}, thrown.what()});
    }
  }
  found.asked = program().asked;
  return found;
}

bool same_answers(const std::vector<Answer>& a, const std::vector<Answer>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Answer& x, const Answer& y) { return same(x, y); });
}

template <typename Map>
std::vector<std::string> names(const Map& map) {
  std::vector<std::string> all;
  for (const auto& [name, value] : map) all.push_back(name);
  for (const auto& [name, value] : whole_styles()) all.push_back(name);
  return all;
}

std::vector<std::string> styles(int part) {
  return part == 1   ? names(part1_styles())
         : part == 2 ? names(part2_styles())
         : part == 3 ? names(part3_styles())
                     : names(part4_styles());
}

// The programs of one style: each slip alone, and random pairs.
std::vector<Slips> programs(const Slips& slips, int pairs, std::mt19937& random) {
  std::vector<Slips> all;
  for (const auto& slip : slips) all.push_back({slip});
  const std::vector<std::string> list(slips.begin(), slips.end());
  for (int i = 0; i < pairs; ++i) {
    const Slips two{list[random() % list.size()], list[random() % list.size()]};
    if (two.size() == 2) all.push_back(two);
  }
  return all;
}

void hunt(int part, int pairs, std::mt19937& random) {
  std::ifstream in(public_file(part, "mistakes").value());
  const KnownMistakes known = read_mistakes(in, part);
  const std::vector<Case> cases = questions(part);
  for (const std::string& style : styles(part)) {
    const Run right = run(part, style, cases, {});
    if (!same_answers(right.answers, known.right)) {
      throw std::runtime_error("part " + std::to_string(part) + ", " + style + ": wrong by itself");
    }
    Slips slips = right.asked;
    for (const auto& slip : right.asked) slips.merge(run(part, style, cases, {slip}).asked);
    for (const Slips& held : programs(slips, pairs, random)) {
      const std::vector<Answer> got = run(part, style, cases, held).answers;
      nlohmann::json line{{"part", part}, {"style", style}, {"slips", held}};
      line["right"] = same_answers(got, known.right);
      line["mistakes"] = nlohmann::json::array();
      for (const Mistake& m : recognise(known, got)) line["mistakes"].push_back(m.name);
      line["patterns"] = patterns(part, cases, known.right, got);
      std::cout << line.dump() << "\n";
    }
  }
}

}  // namespace
}  // namespace slips

int main(int argc, char** argv) try {
  if (argc != 3) throw std::runtime_error("usage: slips FIXTURES PAIRS");
  bounce::fixtures = argv[1];
  std::mt19937 random(1);
  for (const int part : {1, 2, 3, 4}) slips::hunt(part, std::stoi(argv[2]), random);
  return 0;
} catch (const std::exception& e) {
  std::cerr << "slips: " << e.what() << "\n";
  return 3;
}
