#include "diagnostic_questions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bounce::tests {
namespace {

using Change = void (*)(Case&);

constexpr double kTurn = 0.11;
constexpr int kColumns = 40;  // in which most trajectories touch the ground

Case changed(Case c, Change change) {
  change(c);
  return c;
}

// Each parameter alone. The side grows, so that a corner that touches goes on touching.
const std::vector<Change>& one_parameter() {
  static const std::vector<Change> changes{[](Case& c) { c.params.l *= 1.25; },
                                           [](Case& c) { c.params.m *= 1.5; },
                                           [](Case& c) { c.params.mu *= 1.2; },
                                           [](Case& c) { c.params.epsilon *= 0.8; },
                                           [](Case& c) {
                                             c.params.g(0) += 1.3;
                                             c.params.g(1) -= 0.9;
                                           },
                                           [](Case& c) { c.params.dt *= 0.8; },
                                           [](Case& c) { c.params.delta *= 1.5; }};
  return changes;
}

// Turned by quarters, the same square stands on another corner: the one before, counter-clockwise.
Case turned(Case c, int quarters) {
  c.q(2) += quarters * std::numbers::pi / 2;
  const std::size_t at = c.corner.find("corner ");
  if (at != std::string::npos) {
    char& number = c.corner[at + 7];
    number = static_cast<char>('1' + (number - '1' + 4 - quarters) % 4);
  }
  return c;
}

// Whether the same corner is the lowest once the square has turned a little more.
bool has_room_to_turn(const Case& c) {
  const double quarter = std::numbers::pi / 2;
  const double in_quarter = c.q(2) - quarter * std::floor(c.q(2) / quarter);
  return in_quarter > 0.01 && in_quarter + kTurn < quarter - 0.01;
}

// A corner in contact, raised out of it or lowered.
Case raised(Case c, double height) {
  c.q(1) += height;
  if (height > 0) c.corner = "no corner touches; " + c.corner.substr(0, 8) + " is the lowest";
  return c;
}

// The first cases, at most so many, whose name or corner says these words.
std::vector<Case> those_that_say(const std::string& words, std::size_t most,
                                 const std::vector<Case>& cases) {
  std::vector<Case> found;
  for (const Case& c : cases) {
    if (found.size() < most && (c.name + ", " + c.corner).find(words) != std::string::npos) {
      found.push_back(c);
    }
  }
  return found;
}

void add_one_parameter_each(std::vector<Case>& questions, const Case& base) {
  for (const Change change : one_parameter()) questions.push_back(changed(base, change));
}

std::vector<Case> of_part1(const std::vector<Case>& cases) {
  std::vector<Case> questions, bases = those_that_say("corner 3", 2, cases);
  const std::vector<Case> below = those_that_say("below the ground", 1, cases);
  bases.insert(bases.end(), below.begin(), below.end());
  for (const Case& c : bases) {
    for (const int quarters : {1, 2, 3}) questions.push_back(turned(c, quarters));
    questions.push_back(changed(c, [](Case& larger) { larger.params.l *= 20; }));
    questions.push_back(changed(c, [](Case& aside) { aside.q(0) += 0.7; }));
    questions.push_back(changed(c, [](Case& higher) { higher.q(1) += 0.4; }));
    if (has_room_to_turn(c)) questions.push_back(changed(c, [](Case& on) { on.q(2) += kTurn; }));
  }
  return questions;
}

std::vector<Case> of_part2(const std::vector<Case>& cases) {
  std::vector<Case> questions;
  for (const Case& c : {cases.front(), cases.back()}) {
    add_one_parameter_each(questions, c);
    questions.push_back(changed(c, [](Case& turned_round) { turned_round.v *= -1; }));
    add_one_parameter_each(questions, Case(questions.back()));
  }
  return questions;
}

std::vector<Case> of_part3(const std::vector<Case>& cases) {
  std::vector<Case> questions;
  for (const char* what : {"0 < phi < delta", "no corner touches", "sticks", "leaves"}) {
    for (const Case& c : those_that_say(what, 1, cases)) add_one_parameter_each(questions, c);
  }
  for (const Case& c : those_that_say("slides to the left", 1, cases)) {
    questions.push_back(raised(c, -c.params.l));  // below any threshold
    add_one_parameter_each(questions, Case(questions.back()));
  }
  for (const Case& c : those_that_say("0 < phi < delta", 2, cases)) {
    for (const double height : {0.06, 0.02, -c.params.delta}) {
      questions.push_back(raised(c, height));
      questions.push_back(changed(questions.back(), [](Case& up) { up.v(1) = 0.5; }));
    }
  }
  return questions;
}

std::vector<Case> of_part4(const std::vector<Case>& cases) {
  std::vector<Case> questions;
  const auto base = std::find_if(cases.begin(), cases.end(),
                                 [](const Case& c) { return c.params.T == kColumns; });
  if (base != cases.end()) add_one_parameter_each(questions, *base);
  return questions;
}

}  // namespace

std::vector<Case> diagnostic_questions(int part, const std::vector<Case>& cases) {
  if (cases.empty()) return {};
  return part == 1   ? of_part1(cases)
         : part == 2 ? of_part2(cases)
         : part == 3 ? of_part3(cases)
                     : of_part4(cases);
}

}  // namespace bounce::tests
