// The patterns found in made-up wrong answers.
#include "../../parts/pattern.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bounce::tests {
namespace {

constexpr int kCases = 12;

using Change = std::function<void(const Case&, Eigen::VectorXd&)>;

// Four of them with another l and m; the corners, and what they do, in turn.
std::vector<Case> some_cases() {
  std::vector<Case> cases;
  for (int k = 0; k < kCases; ++k) {
    Case c;
    c.q = {0.5 * k + 1, 0.3, k % 2 == 0 ? 0.4 + k : -0.7 - k};
    c.v = {1.5 - k, -1, 0.5};
    c.J << 1, 0, 0, 1, 0.1, 0.2;
    c.corner = "corner " + std::to_string(k % 4 + 1) +
               (k % 4 < 2 ? " touches and slides to the right" : " touches and sticks");
    c.params.T = 5;
    if (k >= 8) c.params.l = c.params.m = 0.7;
    cases.push_back(c);
  }
  return cases;
}

std::vector<Answer> right_answers(int part) {
  const int size = part == 1 ? 7 : part == 2 ? 20 : part == 3 ? 6 : 30;
  std::vector<Answer> answers;
  for (int k = 0; k < kCases; ++k) {
    Answer answer{Eigen::VectorXd(size), ""};
    for (int i = 0; i < size; ++i) answer.numbers(i) = 1 + 0.37 * i + 1.1 * k * (i % 3 + 1);
    answers.push_back(answer);
  }
  return answers;
}

std::string told(int part, const Change& change) {
  const std::vector<Case> cases = some_cases();
  std::vector<Answer> got = right_answers(part);
  for (std::size_t k = 0; k < cases.size(); ++k) change(cases[k], got[k].numbers);
  std::string text;
  for (const auto& sentence : patterns(part, cases, right_answers(part), got)) {
    text += sentence + "\n";
  }
  return text;
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(pattern, SaysNothingOfRightAnswers) {
  for (const int part : {1, 2, 3, 4}) {
    EXPECT_EQ(told(part, [](const Case&, Eigen::VectorXd&) {}), "");
  }
}

TEST(pattern, SaysNothingOfAStub) {
  EXPECT_EQ(told(1, [](const Case&, auto& x) { x.setZero(); }), "");
}

TEST(pattern, NamesWhatIsRightAndWhatIsWrong) {
  const std::string text = told(1, [](const Case& c, auto& x) { x(2) += c.q(0) * c.q(2); });
  EXPECT_TRUE(says(text, "Right in every question: J_n and phi; wrong: J_t (third entry)."))
      << text;
  EXPECT_FALSE(says(text, "times") || says(text, "only where")) << text;
}

TEST(pattern, NamesAFactorAndASign) {
  EXPECT_TRUE(says(told(1, [](const Case&, auto& x) { x(0) = -x(0); }),
                   "Every wrong number is -1 times the right one."));
  EXPECT_TRUE(says(told(2, [](const Case& c, auto& x) { x *= c.params.m; }),
                   "Every wrong number is m times the right one."));
  EXPECT_TRUE(says(told(3, [](const Case&, auto& x) { x.tail(3) *= 0.75; }),
                   "Every wrong number is 0.75 times the right one."));
}

TEST(pattern, NamesTheFactorsOfTwoQuantities) {
  const std::string text = told(1, [](const Case&, auto& x) {
    x(0) = -x(0);
    x(6) *= 2;
  });
  EXPECT_TRUE(says(text, "Every wrong number in J_t is -1 times the right one.")) << text;
  EXPECT_TRUE(says(text, "phi is 2 times the right one.")) << text;
}

TEST(pattern, NamesADifferenceThatIsAlwaysTheSame) {
  EXPECT_TRUE(says(told(2, [](const Case&, auto& x) { x(16) += 0.5; }),
                   "Every wrong number is 0.5 more than the right one."));
}

TEST(pattern, NamesANumberThatIsTheSameWhateverTheQuestion) {
  EXPECT_TRUE(says(told(1, [](const Case&, auto& x) { x(0) = 7; }),
                   "Every wrong number is 7, whatever the question."));
}

TEST(pattern, NamesExchangedPlaces) {
  EXPECT_TRUE(says(told(1,
                        [](const Case&, auto& x) {
                          const Eigen::Vector3d first = x.head(3);
                          x.head(3) = x.segment(3, 3).eval();
                          x.segment(3, 3) = first;
                        }),
                   "the two columns of J are exchanged"));
  EXPECT_TRUE(says(told(2,
                        [](const Case&, auto& x) {
                          Eigen::Map<Eigen::Matrix4d> V(x.data());
                          V.transposeInPlace();
                        }),
                   "V is transposed"));
  EXPECT_TRUE(says(told(2, [](const Case&, auto& x) { std::swap(x(17), x(18)); }),
                   "p(1) and p(2) are exchanged"));
}

// A rounding error of 0 is no factor.
TEST(pattern, NamesNoFactorThatIsARoundingError) {
  const std::string text = told(3, [](const Case&, auto& x) { x.head(3) *= 4.04769e-15; });
  EXPECT_FALSE(says(text, "times")) << text;
}

TEST(pattern, NamesTheParametersThatAreNotTheAssignments) {
  const std::string text = told(2, [](const Case& c, auto& x) {
    if (c.params.l != 0.2) x(0) += c.q(0) * c.q(0);
  });
  EXPECT_TRUE(says(text, "Wrong only where l or m aren't the assignment's, in all 4 such cases"))
      << text;
}

// Two of these four cases are wrong: that may as well be something else.
TEST(pattern, NamesNoParametersWhereHalfOfTheirCasesAreRight) {
  const std::string text = told(2, [](const Case& c, auto& x) {
    if (c.params.l != 0.2 && c.q(0) > 5.7) x(0) += c.q(0) * c.q(0);
  });
  EXPECT_FALSE(says(text, "the assignment's")) << text;
}

TEST(pattern, NamesTheCornerTheModeAndTheAngle) {
  const auto where = [](const std::function<bool(const Case&)>& is_wrong) {
    return told(3, [&](const Case& c, auto& x) {
      if (is_wrong(c)) x(4) += c.q(0) * c.v(0);
    });
  };
  EXPECT_TRUE(says(where([](const Case& c) { return c.corner[7] == '2'; }),
                   "Wrong only where corner 2 is the lowest, in all 3 such cases."));
  EXPECT_TRUE(says(where([](const Case& c) { return c.corner[7] != '2'; }),
                   "Wrong only where corner 2 is not the lowest, in all 9 such cases."));
  EXPECT_TRUE(says(where([](const Case& c) { return c.corner[7] >= '3'; }),
                   "Wrong only where the corner sticks, in all 6 such cases."));
  EXPECT_TRUE(says(where([](const Case& c) { return c.q(2) < 0; }),
                   "Wrong only where theta is negative, in all 6 such cases."));
}

TEST(pattern, NamesNoCasesWhereTooFewAreRight) {
  const std::string text = told(3, [](const Case& c, auto& x) {
    if (c.q(0) > 1.6) x(4) += c.q(0);
  });
  EXPECT_FALSE(says(text, "only where")) << text;
}

TEST(pattern, NamesTooFewDigits) {
  const std::string text =
      told(1, [](const Case&, auto& x) { x = x.template cast<float>().template cast<double>(); });
  EXPECT_TRUE(says(text, "is there a float")) << text;
}

TEST(pattern, NamesTheFirstWrongColumn) {
  const auto from = [](Eigen::Index column) {
    return told(4, [column](const Case&, auto& x) { x.tail(x.size() - 6 * column) *= 1.5; });
  };
  EXPECT_TRUE(says(from(0), "Column 0 is the first wrong one in every case that is wrong."));
  EXPECT_TRUE(says(from(1), "Column 1 is the first wrong one in every case that is wrong."));
  EXPECT_TRUE(says(from(3), "Column 0 is right in every question"));
}

// --- questions that differ in one input alone ---

// Squares on each of their corners, with l changed alone, x changed alone, and the first one again.
std::vector<Case> squares() {
  std::vector<Case> cases;
  for (int k = 0; k < 8; ++k) {
    Case c;
    c.q = {0.5, k < 4 ? 1.0 : -0.3, 0.3 + 1.57 * k};
    c.corner = "corner " + std::to_string(k % 4 + 1) + " is the lowest";
    cases.push_back(c);
  }
  cases.push_back(cases[0]);
  cases.back().params.l = 0.5;
  cases.push_back(cases[0]);
  cases.back().q(0) = 3;
  cases.push_back(cases[0]);
  return cases;
}

// J and phi of a corner so many places after the lowest one.
Eigen::VectorXd of_corner(const Case& c, int places) {
  Eigen::Vector2d r = c.params.l * Eigen::Vector2d(0.2, -0.7);
  for (int k = 0; k < places; ++k) r = Eigen::Vector2d(-r.y(), r.x());
  Eigen::VectorXd all(7);
  all << 1, 0, -r.y(), 0, 1, r.x(), c.q(1) + r.y();
  return all;
}

std::string told_of_squares(const std::function<Eigen::VectorXd(const Case&)>& program) {
  const std::vector<Case> cases = squares();
  std::vector<Answer> right, got;
  for (const Case& c : cases) right.push_back({of_corner(c, 0), ""});
  for (const Case& c : cases) got.push_back({program(c), ""});
  std::string text;
  for (const auto& sentence : patterns(1, cases, right, got)) text += sentence + "\n";
  return text;
}

TEST(pattern, NamesAnInputThatMakesNoDifference) {
  const std::string text = told_of_squares([](Case c) {
    c.params.l = 0.4;
    return of_corner(c, 0);
  });
  EXPECT_TRUE(says(text,
                   "Where only l is changed, J_t, J_n and phi stay the same in your "
                   "answers, and they should change."))
      << text;
}

TEST(pattern, NamesAnInputThatShouldMakeNoDifference) {
  const std::string text = told_of_squares([](const Case& c) {
    Eigen::VectorXd x = of_corner(c, 0);
    x(5) += c.q(0);
    return x;
  });
  EXPECT_TRUE(says(text,
                   "Where only x is changed, J_n changes in your answers, and it should "
                   "stay the same."))
      << text;
}

TEST(pattern, NamesWhatOutlivesACall) {
  int calls = 0;
  const std::string text = told_of_squares([&](const Case& c) {
    Eigen::VectorXd x = of_corner(c, 0);
    x(6) += ++calls;
    return x;
  });
  EXPECT_TRUE(says(text, "The same question, asked again after others, gets another answer"))
      << text;
}

TEST(pattern, NamesTheCornersThatAreNeverChosen) {
  const auto taken_in_place_of = [](const std::string& corners, int places) {
    return told_of_squares([=](const Case& c) {
      return of_corner(c, corners.find(c.corner[7]) == std::string::npos ? 0 : places);
    });
  };
  EXPECT_TRUE(says(taken_in_place_of("4", 3), "Corner 4 is never chosen"));
  EXPECT_TRUE(says(taken_in_place_of("13", 3), "Corners 1 and 3 are never chosen"));
  const std::string always =
      told_of_squares([](const Case& c) { return of_corner(c, (6 - (c.corner[7] - '0')) % 4); });
  EXPECT_TRUE(says(always, "Your answer is always that of corner 2.")) << always;
}

TEST(pattern, NamesTheFormulaOfPhi) {
  const auto of_phi = [](double (*phi)(const Case&, double)) {
    return told_of_squares([=](const Case& c) {
      Eigen::VectorXd x = of_corner(c, 0);
      x(6) = phi(c, x(6));
      return x;
    });
  };
  EXPECT_TRUE(says(of_phi([](const Case& c, double) { return c.q(1) - c.params.l / 2; }),
                   "Your phi is y - l/2 in every question."));
  EXPECT_TRUE(says(of_phi([](const Case&, double phi) { return std::abs(phi); }),
                   "Your phi is the absolute value of phi in every question."));
  const std::string none = of_phi([](const Case& c, double phi) { return phi + c.q(2) * c.q(1); });
  EXPECT_FALSE(says(none, "Your phi is")) << none;
}

TEST(pattern, LeavesOutWhatIsNoNumberAndWhatThrew) {
  std::vector<Answer> got = right_answers(1);
  got[3] = {{}, "thrown"};
  got[4].numbers(6) = NAN;
  const auto told = patterns(1, some_cases(), right_answers(1), got);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(says(told[0], "wrong: phi."));
  EXPECT_TRUE(patterns(1, some_cases(), right_answers(1), {}).empty());
}

}  // namespace
}  // namespace bounce::tests
