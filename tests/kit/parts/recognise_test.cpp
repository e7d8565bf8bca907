// The mistakes recognised in made-up answers.
#include "../../parts/recognise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace bounce::tests {
namespace {

using Names = std::vector<std::string>;

constexpr int kCases = 5;

std::vector<Answer> right_answers() {
  std::vector<Answer> answers;
  for (int k = 0; k < kCases; ++k) {
    answers.push_back({Eigen::Vector4d(1 + k, 2.5 * k + 1, 0.1 * k - 7, 3), ""});
  }
  return answers;
}

// The right answers with one entry of each changed.
std::vector<Answer> changed(Eigen::Index entry, double (*change)(double)) {
  std::vector<Answer> answers = right_answers();
  for (Answer& answer : answers) answer.numbers(entry) = change(answer.numbers(entry));
  return answers;
}

double negated(double x) { return -x; }
double doubled(double x) { return 2 * x; }
double raised(double x) { return x + 0.25; }

Mistake mistake(const std::string& name, const std::vector<Answer>& answers) {
  return {name, name, "", "", {}, answers};
}

KnownMistakes known(std::vector<Mistake> mistakes) {
  return {4, right_answers(), std::move(mistakes)};
}

KnownMistakes three() {
  return known({mistake("first negated", changed(0, negated)),
                mistake("second raised", changed(1, raised)),
                mistake("first doubled", changed(0, doubled))});
}

Names names(const KnownMistakes& all, const std::vector<Answer>& got) {
  Names found;
  for (const Mistake& m : recognise(all, got)) found.push_back(m.name);
  return found;
}

TEST(recognise, NamesTheMistakeThatExplainsEveryAnswer) {
  for (const Mistake& m : three().mistakes) EXPECT_EQ(names(three(), m.answers), Names{m.name});
}

TEST(recognise, NamesNothingWhereEverythingIsRight) {
  EXPECT_TRUE(names(three(), right_answers()).empty());
}

TEST(recognise, ToleratesRoundingAndNothingElse) {
  std::vector<Answer> got = changed(0, negated);
  for (Answer& answer : got) answer.numbers *= 1 + 1e-12;
  EXPECT_EQ(names(three(), got), Names{"first negated"});
  got[2].numbers(3) += 1e-6;
  EXPECT_TRUE(names(three(), got).empty());
}

TEST(recognise, NamesNothingWhereOneAnswerIsOtherwise) {
  std::vector<Answer> got = changed(0, negated);
  got[4] = right_answers()[4];
  EXPECT_TRUE(names(three(), got).empty());
}

TEST(recognise, ComposesTwoMistakesThatTouchOtherEntries) {
  std::vector<Answer> got = changed(0, negated);
  for (Answer& answer : got) answer.numbers(1) = raised(answer.numbers(1));
  EXPECT_EQ(names(three(), got), (Names{"first negated", "second raised"}));
}

// The first mistake changes entries 0 and 2, the second 1 and 2.
std::vector<Answer> overlapping(Eigen::Index own, double (*change)(double)) {
  std::vector<Answer> answers = changed(own, change);
  for (Answer& answer : answers) answer.numbers(2) = change(answer.numbers(2));
  return answers;
}

std::vector<Answer> with_both(double (*a)(double), double (*b)(double), double (*both)(double)) {
  std::vector<Answer> answers = overlapping(0, a);
  for (Answer& answer : answers) answer.numbers(1) = b(answer.numbers(1));
  for (std::size_t k = 0; k < answers.size(); ++k) {
    answers[k].numbers(2) = both(right_answers()[k].numbers(2));
  }
  return answers;
}

TEST(recognise, ComposesSumsAndProducts) {
  const auto both = [](double (*a)(double), double (*b)(double), double (*composed)(double)) {
    const KnownMistakes two =
        known({mistake("a", overlapping(0, a)), mistake("b", overlapping(1, b))});
    return names(two, with_both(a, b, composed));
  };
  const Names pair{"a", "b"};
  EXPECT_EQ(both(negated, doubled, [](double x) { return -2 * x; }), pair);
  EXPECT_EQ(both(negated, raised, [](double x) { return -x + 0.25; }), pair);
  // One that hides the other: what is seen there may as well be a third mistake.
  EXPECT_EQ(both(negated, raised, negated), Names{});
  EXPECT_EQ(both(negated, raised, raised), Names{});
  EXPECT_EQ(both(negated, raised, [](double x) { return 7 * x; }), Names{});
}

TEST(recognise, TakesOneRuleForAllEntriesOfAPair) {
  std::vector<Answer> got = with_both(negated, doubled, negated);
  got[0].numbers(2) = -2 * right_answers()[0].numbers(2);  // a product here, what hides there
  const KnownMistakes two =
      known({mistake("a", overlapping(0, negated)), mistake("b", overlapping(1, doubled))});
  EXPECT_TRUE(names(two, got).empty());
}

// A pair that shows only together could be many others.
TEST(recognise, IsSilentOnAPairOfWhichOneNeverShowsByItself) {
  std::vector<Answer> got = changed(0, negated);
  for (Answer& answer : got) answer.numbers(0) = doubled(answer.numbers(0));
  EXPECT_TRUE(names(three(), got).empty());
}

// The one changes two entries, the other one of these.
TEST(recognise, IsSilentOnAPairOfWhichOneShowsBesideTheOtherAlone) {
  std::vector<Answer> wide = changed(0, negated), got = changed(0, negated);
  for (int k = 0; k < kCases; ++k) {
    const auto i = static_cast<std::size_t>(k);
    wide[i].numbers(1) = -wide[i].numbers(1);
    got[i].numbers(0) = 2 * got[i].numbers(0);
    got[i].numbers(1) = wide[i].numbers(1);
  }
  EXPECT_TRUE(
      names(known({mistake("wide", wide), mistake("narrow", changed(0, doubled))}), got).empty());
}

// Part 3: the move, then v'. A mistake in v' is known whatever moves q.
TEST(recognise, KnowsAVelocityBesideAnUnknownMove) {
  std::vector<Answer> right, wrong, got;
  for (int k = 0; k < kCases; ++k) {
    Eigen::VectorXd numbers(6);
    numbers << 0, 0.001, 0, 1 + k, 2.5 * k + 1, 0.1 * k - 7;
    right.push_back({numbers, ""});
    numbers(4) *= -1;
    wrong.push_back({numbers, ""});
    numbers(0) = 0.3 * k * k - 1;
    got.push_back({numbers, ""});
  }
  const KnownMistakes one{6, right, {mistake("falls up", wrong)}};
  EXPECT_EQ(names(one, got), Names{"falls up"});
  got[2].numbers(3) += 1e-6;
  EXPECT_TRUE(names(one, got).empty());
}

TEST(recognise, NamesNoPairThatMakesUpForItself) {
  const auto halved = [](double x) { return x / 2; };
  const KnownMistakes two =
      known({mistake("doubled", changed(0, doubled)), mistake("halved", changed(0, halved))});
  EXPECT_TRUE(names(two, right_answers()).empty());
}

// Four numbers in two questions, or more.
TEST(recognise, IsSilentWhereAMistakeShowsTooSeldom) {
  std::vector<Answer> seldom = right_answers();
  for (int k = 0; k < 3; ++k) seldom[static_cast<std::size_t>(k)].numbers(0) += 1;
  EXPECT_TRUE(names(known({mistake("seldom", seldom)}), seldom).empty());
  seldom[3].numbers(0) += 1;
  EXPECT_EQ(names(known({mistake("seldom", seldom)}), seldom), Names{"seldom"});

  std::vector<Answer> once = right_answers();
  once[0].numbers.array() += 1;
  EXPECT_TRUE(names(known({mistake("once", once)}), once).empty());
}

TEST(recognise, IsSilentWhereThePairsExplainNothingInCommon) {
  std::vector<Answer> a = changed(0, raised), b = changed(1, raised), got = changed(0, raised);
  for (Answer& answer : got) answer.numbers(1) = raised(answer.numbers(1));
  std::vector<Answer> c = a, d = b;  // the same in other words
  EXPECT_EQ(names(known({mistake("a", a), mistake("b", b)}), got), (Names{"a", "b"}));
  EXPECT_EQ(names(known({mistake("a", a), mistake("b", b), mistake("d", d)}), got), Names{"a"});
  EXPECT_TRUE(
      names(known({mistake("a", a), mistake("b", b), mistake("c", c), mistake("d", d)}), got)
          .empty());
}

TEST(recognise, PrefersOneMistakeToTwo) {
  std::vector<Answer> both = changed(0, negated);
  for (Answer& answer : both) answer.numbers(1) = raised(answer.numbers(1));
  KnownMistakes all = three();
  all.mistakes.push_back(mistake("both", both));
  EXPECT_EQ(names(all, both), Names{"both"});
}

TEST(recognise, KnowsAnAnswerByWhatWasThrown) {
  std::vector<Answer> thrown(kCases, Answer{{}, "q is 3x2"}), other(kCases, Answer{{}, "not yet"});
  EXPECT_EQ(names(known({mistake("shape", thrown)}), thrown), Names{"shape"});
  EXPECT_TRUE(names(known({mistake("shape", thrown)}), other).empty());
}

TEST(recognise, NamesNothingWhereANumberIsGarbage) {
  const std::vector<Answer> garbage = changed(0, [](double) { return 6.9e-310; });
  EXPECT_TRUE(names(known({mistake("left zero", changed(0, [](double) { return 0.0; }))}), garbage)
                  .empty());
}

TEST(recognise, TakesNoNumberForNoEvidence) {
  const std::vector<Answer> nan = changed(0, [](double) { return double(NAN); });
  EXPECT_TRUE(names(known({mistake("nan", nan)}), nan).empty());
}

TEST(recognise, IsSilentWhereQuestionsAreMissing) {
  EXPECT_TRUE(names(three(), {}).empty());
  EXPECT_TRUE(names(three(), {changed(0, negated)[0]}).empty());
}

TEST(recognise, ReadsWhatDiffersFromTheRightAnswers) {
  std::istringstream file(R"({"right": [[1, 2], [3, 4]], "mistakes": [
    {"name": "part1_a", "title": "A", "sentence": "B.", "equations": [4, 5], "hint": "1.1 H",
     "checks": [], "answers": {"0": {"1": -2}, "1": "thrown"}}]})");
  const KnownMistakes read = read_mistakes(file, 1);
  ASSERT_EQ(read.mistakes.size(), 1u);
  const Mistake& m = read.mistakes[0];
  EXPECT_EQ(m.name + m.title + m.sentence + m.hint, "part1_aAB.1.1 H");
  EXPECT_EQ(m.equations, (std::vector<int>{4, 5}));
  EXPECT_EQ(m.answers[0].numbers, Eigen::Vector2d(1, -2));
  EXPECT_EQ(m.answers[1].thrown, "thrown");
}

TEST(recognise, RefusesAnEntryThatNoAnswerHas) {
  std::istringstream file(R"({"right": [[1, 2]], "mistakes": [{"name": "", "title": "",
    "sentence": "", "equations": [], "hint": "", "checks": [], "answers": {"0": {"2": 1}}}]})");
  EXPECT_THROW(read_mistakes(file, 1), std::runtime_error);
}

}  // namespace
}  // namespace bounce::tests
