// Which known mistakes are recognised in made-up answers: five questions with four numbers each.
#include "../../../grader/diagnosis/recognise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace bounce::tests {
namespace {

using Answers = std::vector<Answer>;
using Change = double (*)(double);

double same(double x) { return x; }
double negated(double x) { return -x; }
double doubled(double x) { return 2 * x; }
double halved(double x) { return x / 2; }
double raised(double x) { return x + 0.25; }
double seven_times(double x) { return 7 * x; }
double negated_and_doubled(double x) { return -2 * x; }
double negated_and_raised(double x) { return -x + 0.25; }
double garbage(double) { return 6.9e-310; }
double zero(double) { return 0; }
double none(double) { return NAN; }

// The answers of a program that changes each of the four numbers so, in these questions.
Answers with(Change a, Change b = same, Change c = same, int first = 0, int end = 5) {
  Answers answers;
  for (int k = 0; k < 5; ++k) {
    Eigen::Vector4d x(1 + k, 2.5 * k + 1, 0.1 * k - 7, 3);
    if (first <= k && k < end) x.head(3) << a(x(0)), b(x(1)), c(x(2));
    answers.push_back({x, ""});
  }
  return answers;
}

Answers throwing(const std::string& what) { return Answers(5, Answer{{}, what}); }

Answers changed(Answers answers, std::size_t question, Eigen::Index entry, double by) {
  answers[question].numbers(entry) += by;
  return answers;
}

// Known mistakes are called a, b, c, ...; what is recognised is told by their names.
std::string names(const std::vector<Answers>& known, const Answers& got) {
  KnownMistakes all{4, with(same), {}};
  for (const Answers& answers : known) {
    all.mistakes.push_back(
        {std::string(1, char('a' + all.mistakes.size())), "", "", "", {}, {}, answers});
  }
  std::string found;
  for (const Mistake& m : recognise(all, got)) found += m.name;
  return found;
}

struct Program {
  const char* why;
  std::vector<Answers> known;
  Answers got;
  const char* names;
};

const Answers kA = with(raised), kB = with(same, raised), kBoth = with(raised, raised);
const Answers kThreeNumbers = with(raised, same, same, 0, 3);
const Answers kFourNumbers = with(raised, same, same, 0, 4);
const Answers kOneQuestion = with(raised, raised, raised, 0, 1);
const Answers kWide = with(negated, negated), kNarrow = with(doubled);
const Answers kThrown = throwing("q is 3x2");
const std::vector<Answers> kThree{with(negated), with(same, raised), with(doubled)};
const std::vector<Answers> kOverlapping{with(negated, same, negated), with(same, doubled, doubled)};
const std::vector<Answers> kSum{with(negated, same, negated), with(same, raised, raised)};

const Program kPrograms[] = {
    {"nothing is wrong", kThree, with(same), ""},
    {"it explains every answer", kThree, with(doubled), "c"},
    {"one answer is otherwise", kThree, with(negated, same, same, 0, 4), ""},
    {"one number is otherwise", kThree, changed(with(negated), 2, 3, 1e-6), ""},
    {"one number is rounded", kThree, changed(with(negated), 2, 3, 1e-12), "a"},
    {"two touch other numbers", kThree, with(negated, raised), "ab"},
    {"two make a product", kOverlapping, with(negated, doubled, negated_and_doubled), "ab"},
    {"two make a sum", kSum, with(negated, raised, negated_and_raised), "ab"},
    {"one hides the other, or a third", kSum, with(negated, raised, negated), ""},
    {"the other hides it, or a third", kSum, with(negated, raised, raised), ""},
    {"neither is seen in the third", kSum, with(negated, raised, seven_times), ""},
    {"a product in one answer alone", kOverlapping,
     changed(with(negated, doubled, negated), 0, 2, -7), ""},
    {"two that show only together", kThree, with(negated_and_doubled), ""},
    {"one shows beside the other alone", {kWide, kNarrow}, with(negated_and_doubled, negated), ""},
    {"two make up for each other", {with(doubled), with(halved)}, with(same), ""},
    {"three numbers are too few", {kThreeNumbers}, kThreeNumbers, ""},
    {"four numbers are enough", {kFourNumbers}, kFourNumbers, "a"},
    {"one question is too few", {kOneQuestion}, kOneQuestion, ""},
    {"two pairs have one in common", {kA, kB, kB}, kBoth, "a"},
    {"pairs have nothing in common", {kA, kB, kA, kB}, kBoth, ""},
    {"one is preferred to two", {kA, kB, kBoth}, kBoth, "c"},
    {"what was thrown is the same", {kThrown}, kThrown, "a"},
    {"what was thrown is another", {kThrown}, throwing("not yet"), ""},
    {"garbage is no 0", {with(zero)}, with(garbage), ""},
    {"NaN has many causes", {with(none)}, with(none), ""},
    {"questions are missing", kThree, {}, ""},
    {"questions are missing", kThree, {with(negated)[0]}, ""},
};

TEST(recognise, NamesWhatExplainsEveryAnswerAndNothingElse) {
  for (const Program& row : kPrograms) EXPECT_EQ(names(row.known, row.got), row.names) << row.why;
}

// Part 3: the move, then v'. A mistake in v' is known whatever moves q.
TEST(recognise, KnowsAVelocityBesideAnUnknownMove) {
  Answers right, wrong, got;
  for (int k = 0; k < 5; ++k) {
    Eigen::VectorXd numbers(6);
    numbers << 0, 0.001, 0, 1 + k, 2.5 * k + 1, 0.1 * k - 7;
    right.push_back({numbers, ""});
    numbers(4) *= -1;
    wrong.push_back({numbers, ""});
    numbers(0) = 0.3 * k * k - 1;
    got.push_back({numbers, ""});
  }
  const KnownMistakes one{6, right, {{"falls up", "", "", "", {}, {}, wrong}}};
  EXPECT_EQ(recognise(one, got).size(), 1U);
  EXPECT_TRUE(recognise(one, changed(got, 2, 3, 1e-6)).empty());
}

}  // namespace
}  // namespace bounce::tests
