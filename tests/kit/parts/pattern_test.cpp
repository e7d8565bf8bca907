// The patterns found in made-up wrong answers.
#include "../../parts/pattern.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace bounce::tests {
namespace {

constexpr int kCases = 12;

using Change = std::function<void(const Case&, Eigen::VectorXd&)>;

// Four of them with another l and m; the corners, and what they do, in turn. All touch the ground.
std::vector<Case> some_cases() {
  std::vector<Case> cases;
  for (int k = 0; k < kCases; ++k) {
    Case c;
    const double turns = k % 2 == 0 ? 0 : -2 - k;
    c.q = {0.5 * k + 1, 0.1, 0.4 + std::numbers::pi / 2 * (4 * turns + (6 - k % 4) % 4)};
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

Eigen::Vector2d lowest_corner(const Case& c) {
  Eigen::Vector2d r(0, 1);
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector2d corner(k % 2 == 0 ? 1 : -1, k < 2 ? 1 : -1);
    const Eigen::Vector2d turned = Eigen::Rotation2Dd(c.q(2)) * corner * c.params.l / 2;
    if (turned.y() < r.y()) r = turned;
  }
  return r;
}

std::vector<Answer> right_answers(int part) {
  const std::vector<Case> cases = some_cases();
  const int size = part == 1 ? 7 : part == 2 ? 20 : part == 3 ? 6 : 30;
  std::vector<Answer> answers;
  for (int k = 0; k < kCases; ++k) {
    Answer answer{Eigen::VectorXd(size), ""};
    for (int i = 0; i < size; ++i) answer.numbers(i) = 1 + 0.37 * i + 1.1 * k * (i % 3 + 1);
    const Case& c = cases[static_cast<std::size_t>(k)];
    const bool sticks = part == 3 && k % 4 >= 2;
    if (sticks) answer.numbers(5) = answer.numbers(3) / lowest_corner(c).y();
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
  EXPECT_TRUE(says(text, "Right in every public question: J_n and phi; wrong: J_t (third entry)."))
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
                   "Every wrong number is 7, whatever the right one."));
  EXPECT_TRUE(says(told(2, [](const Case&, auto& x) { x(0) = INFINITY; }),
                   "Every wrong number is inf. Often: something is divided by 0"));
  EXPECT_TRUE(says(told(2, [](const Case&, auto& x) { x(0) = NAN; }),
                   "Every wrong number is nan: was it ever set?"));
  EXPECT_TRUE(says(told(2, [](const Case& c, auto& x) { x(0) = c.v(0) > 0 ? NAN : INFINITY; }),
                   "Every wrong number is nan or inf: was it ever set?"));
}

// Where p(0) is right, it is another number.
TEST(pattern, SaysOfTheWrongNumbersAloneWhatTheyAre) {
  const std::string text = told(2, [](const Case& c, auto& x) {
    if (c.v(0) > -6) x(16) = 0;
    x(17) += c.q(0) * c.q(0);
  });
  EXPECT_TRUE(says(text, "Every wrong p(0) is 0, whatever the right one.")) << text;
}

// V(3, 3) belongs to both.
TEST(pattern, CallsNoRowRightThatHoldsAWrongEntryOfTheColumn) {
  const std::string text = told(2, [](const Case&, auto& x) { x.segment(12, 4).setConstant(NAN); });
  EXPECT_TRUE(says(text, "wrong: the last column of V and the last row of V (V(3, 3)).")) << text;
}

TEST(pattern, SaysOfGarbageThatItIsNotSet) {
  const std::string text = told(1, [](const Case&, auto& x) { x(5) = 6.9e-310; });
  EXPECT_TRUE(says(text, "A number in an answer is 6.9e-310: was it ever set?")) << text;
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
  EXPECT_TRUE(says(told(1,
                        [](const Case&, auto& x) {
                          const Eigen::VectorXd old = x;
                          x << old(0), old(3), old(1), old(4), old(2), old(5), old(6);
                        }),
                   "J is filled column by column with what belongs into its rows"));
}

TEST(pattern, NamesTheOrderOfTheUnknowns) {
  // f_n last of the forces; V, its border, and p, as far as asked.
  const auto in_order = [](bool border, bool p, double more) {
    return told(2, [=](const Case&, auto& x) {
      const Eigen::Vector4i from(1, 2, 0, 3);
      const Eigen::VectorXd old = x;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
          if (border || (i < 3 && j < 3)) x(i + 4 * j) = old(from(i) + 4 * from(j));
        }
        if (p) x(16 + i) = old(16 + from(i));
      }
      x(5) += more;
    });
  };
  EXPECT_TRUE(
      says(in_order(true, true, 0), "V and p are in the order z = (f_t1, f_t2, f_n, lambda)"));
  EXPECT_TRUE(
      says(in_order(true, false, 0), "V is in the order z = (f_t1, f_t2, f_n, lambda), and p"));
  EXPECT_TRUE(says(in_order(false, true, 0), "lambda), and the border of V isn't."));
  EXPECT_FALSE(says(in_order(true, true, 0.5), "in the order"));
}

TEST(pattern, NamesAnotherInertiaInPlainWords) {
  const auto with = [](double last, double more) {
    return told(2, [=](const Case& c, auto& x) {
      const double m = c.params.m, l = c.params.l;
      Eigen::Matrix3d J_hat;
      J_hat << c.J.col(1), -c.J.col(0), c.J.col(0);
      const Vector3 inverse(1 / m, 1 / m, 1 / (last * l * l));
      Eigen::Map<Eigen::Matrix4d>(x.data()).topLeftCorner<3, 3>() =
          J_hat.transpose() * inverse.asDiagonal() * J_hat * c.params.dt;
      x(0) += more;
    });
  };
  EXPECT_TRUE(says(with(1.0 / 6, 0), "dt with l^2 / 6 for the inertia in every question."));
  EXPECT_FALSE(says(with(1.0 / 6, 0.01), "for the inertia"));
}

TEST(pattern, NamesANumberThatStopsAtABound) {
  const auto bounded = [](double more) {
    return told(3, [=](const Case&, auto& x) {
      if (x(4) > 8) x(4) = x(4) > 20 ? 8 + more : 8;
    });
  };
  EXPECT_TRUE(says(bounded(0), "Your v_y' is min(8, v_y') in every question.")) << bounded(0);
  EXPECT_FALSE(says(bounded(0.1), "min(")) << bounded(0.1);
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
  EXPECT_TRUE(says(from(3), "Column 0 is right in every public question;"));
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

TEST(pattern, AsksWhetherANumberIsKeptFromAnEarlierCall) {
  std::vector<Case> cases = squares();
  std::swap(cases[0], cases[8]);  // first the one whose l isn't the assignment's
  const auto with = [&](double l) {
    std::vector<Answer> right, got;
    for (Case c : cases) {
      right.push_back({of_corner(c, 0), ""});
      c.params.l = l;
      got.push_back({of_corner(c, 0), ""});
    }
    std::string text;
    for (const auto& sentence : patterns(1, cases, right, got)) text += sentence + "\n";
    return text;
  };
  const std::string kept = with(cases[0].params.l);
  EXPECT_TRUE(says(kept, "they should change: kept from an earlier call?")) << kept;
  EXPECT_FALSE(says(with(0.4), "kept")) << with(0.4);
}

TEST(pattern, NamesTheCasesAboveDelta) {
  const auto where = [](bool also_below) {
    return told_of_squares([=](const Case& c) {
      Eigen::VectorXd x = of_corner(c, 0);
      if (x(6) >= c.params.delta || (also_below && c.corner[7] == '2')) x(5) *= 3;
      return x;
    });
  };
  EXPECT_TRUE(says(where(false), "Wrong only where phi >= delta, in all 7 such cases."))
      << where(false);
  EXPECT_FALSE(says(where(true), "only where phi")) << where(true);
}

TEST(pattern, SaysOfNoInputThatItMakesNoDifferenceWhereAWrongEntryDiffers) {
  const std::string text = told_of_squares([](const Case& c) {
    Eigen::VectorXd x = of_corner(c, 0);
    std::swap(x(3), x(5));
    return x;
  });
  EXPECT_FALSE(says(text, "in your answers")) << text;
}

TEST(pattern, NamesAnInputThatShouldMakeNoDifference) {
  const std::string text = told_of_squares([](const Case& c) {
    Eigen::VectorXd x = of_corner(c, 0);
    x(5) += c.q(0) * c.q(0);
    return x;
  });
  EXPECT_TRUE(says(text,
                   "Where only x is changed, J_n changes in your answers, and it should "
                   "stay the same."))
      << text;
}

// Above the ground it is clamped.
TEST(pattern, NamesNoInputThatMakesADifferenceElsewhere) {
  std::vector<Case> cases = squares();
  cases.push_back(cases[5]);
  cases.back().q(1) -= 0.2;
  cases.push_back(cases[5]);
  cases.back().params.l *= 1.25;
  std::vector<Answer> right, got;
  for (const Case& c : cases) right.push_back({of_corner(c, 0), ""});
  for (const Answer& answer : right) {
    got.push_back(answer);
    got.back().numbers(6) = std::min(0.0, answer.numbers(6));
  }
  std::string text;
  for (const auto& sentence : patterns(1, cases, right, got)) text += sentence + "\n";
  EXPECT_FALSE(says(text, "Where only")) << text;
}

TEST(pattern, NamesNoInputWhereAFormulaSaysIt) {
  const std::string text = told_of_squares([](const Case& c) {
    Eigen::VectorXd x = of_corner(c, 0);
    x(6) = c.q(1);
    return x;
  });
  EXPECT_TRUE(says(text, "Your phi is y, the height of the centre in every question.")) << text;
  EXPECT_FALSE(says(text, "Where only")) << text;
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
  EXPECT_TRUE(says(taken_in_place_of("4", 3), "Corners are numbered as in eq. (3)."));
  EXPECT_TRUE(says(taken_in_place_of("13", 3), "Corners 1 and 3 are never chosen"));
  const std::string always =
      told_of_squares([](const Case& c) { return of_corner(c, (6 - (c.corner[7] - '0')) % 4); });
  EXPECT_TRUE(says(always, "Your answer is always that of corner 2.")) << always;
}

TEST(pattern, NamesWhereACornerIsLeftmost) {
  const auto places = [](int of_corner_2) {
    return told_of_squares(
        [=](const Case& c) { return of_corner(c, c.corner[7] == '2' ? of_corner_2 : 3); });
  };
  EXPECT_TRUE(says(places(3), "Your answer is always that of the leftmost corner.")) << places(3);
  EXPECT_FALSE(says(places(0), "leftmost")) << places(0);
}

TEST(pattern, NamesTooFewDigitsOfPi) {
  const auto by = [](double pi) {
    return told_of_squares([=](const Case& c) {
      Eigen::VectorXd x = of_corner(c, 0);
      const Eigen::Rotation2Dd turn((2 * (c.corner[7] - '0') - 1) * (pi - std::numbers::pi) / 4);
      const Eigen::Vector2d r = turn * Eigen::Vector2d(x(5), -x(2));
      x(6) += r.y() + x(2);
      x(2) = -r.y();
      x(5) = r.x();
      return x;
    });
  };
  EXPECT_TRUE(says(by(3.14), "turned by a multiple of (3.14 - pi) / 4 in every question."));
  EXPECT_TRUE(says(by(3.1416), "turned by a multiple of (3.1416 - pi) / 4 in every question."));
  EXPECT_FALSE(says(by(3.15), "pi"));
}

TEST(pattern, NamesAnotherSquareAndAColumnOfLengthOne) {
  const auto square = [](double angle, double side, const Case& c) {
    const double s = side / 2, along = std::sin(angle) < 0 ? s : -s;
    const double aside = std::cos(angle) < 0 ? s : -s;
    const Eigen::Vector2d r = Eigen::Rotation2Dd(angle) * Eigen::Vector2d(along, aside);
    Eigen::VectorXd all(7);
    all << 1, 0, -r.y(), 0, 1, r.x(), c.q(1) + r.y();
    return all;
  };
  const auto told_of = [&](const std::function<Eigen::VectorXd(const Case&)>& program) {
    const std::vector<Case> cases = squares();
    std::vector<Answer> right, got;
    for (const Case& c : cases) right.push_back({square(c.q(2), c.params.l, c), ""});
    for (const Case& c : cases) got.push_back({program(c), ""});
    std::string text;
    for (const auto& sentence : patterns(1, cases, right, got)) text += sentence + "\n";
    return text;
  };
  EXPECT_TRUE(says(told_of([&](auto& c) { return square(c.q(2) / 2, c.params.l, c); }),
                   "a square that is turned by theta / 2 in every question."));
  EXPECT_TRUE(says(told_of([&](auto& c) { return square(c.q(2), c.params.l / std::sqrt(8), c); }),
                   "Your corner is l/4 away from the centre in every question"));
  EXPECT_TRUE(says(told_of([&](auto& c) {
                     Eigen::VectorXd x = square(c.q(2), c.params.l, c);
                     x.segment(3, 3).normalize();
                     return x;
                   }),
                   "Your J_n has the length 1 in every question."));
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
  const auto of_the_side = [](const Case& c, double) {
    const double along = std::abs(std::cos(c.q(2))), aside = std::abs(std::sin(c.q(2)));
    return c.q(1) - c.params.l / 2 * std::max(along, aside);
  };
  EXPECT_TRUE(says(of_phi(of_the_side), "the height of the middle of the lowest side"));
  const std::string none = of_phi([](const Case& c, double phi) { return phi + c.q(2) * c.q(1); });
  EXPECT_FALSE(says(none, "Your phi is")) << none;
}

// --- part 3 ---

// The change of v that the forces make.
Vector3 by_forces(const Case& c, const Eigen::VectorXd& x) {
  return x.tail(3) - c.v - c.params.dt * c.params.g;
}

TEST(pattern, NamesANumberInPlaceOfTheSide) {
  const std::string text = told(3, [](const Case& c, auto& x) {
    x(5) = c.v(2) + (x(5) - c.v(2)) * c.params.l * c.params.l / 0.16;
  });
  EXPECT_TRUE(says(text, "multiplied by (1, 1, l^2 / 0.16).")) << text;
}

TEST(pattern, NamesTheMomentOfTheForces) {
  const auto with = [](double normal, double tangential) {
    return told(3, [=](const Case& c, auto& x) {
      const Eigen::Vector2d r = lowest_corner(c);
      const Vector3 impulse = c.params.M() * by_forces(c, x);
      const double moment = normal * r.x() * impulse(1) + tangential * r.y() * impulse(0);
      x(5) = c.v(2) + moment / c.params.M()(2, 2);
    });
  };
  EXPECT_TRUE(says(with(1, 1), ", is r_x f_n + r_y f_t in every question."));
  EXPECT_TRUE(says(with(-1, 0), ", is -r_x f_n in every question."));
  EXPECT_FALSE(says(with(1, -0.5), "moment"));
}

TEST(pattern, NamesAForceThatIsMultiplied) {
  const std::string text = told(3, [](const Case& c, auto& x) {
    const Eigen::Vector2d r = lowest_corner(c);
    const Vector3 force = c.params.M() * by_forces(c, x);
    const double f_t = c.params.mu * force(0), f_n = force(1);
    const Vector3 all(f_t, f_n, r.x() * f_n - r.y() * f_t);
    x.tail(3) += c.params.M().inverse() * all - by_forces(c, x);
  });
  EXPECT_TRUE(says(text, "your v' is that with f_n multiplied by 1 and f_t by mu.")) << text;
}

TEST(pattern, NamesWhatIsNotMoved) {
  const std::string text = told(3, [](const Case& c, auto& x) { x(2) = -c.params.dt * x(5); });
  EXPECT_TRUE(says(text, "Your theta' is theta in every question.")) << text;
}

// --- part 4 ---

TEST(pattern, NamesTheRowsOfATrajectoryThatAreRight) {
  const std::string text = told(4, [](const Case&, auto& x) {
    for (int i = 6; i < x.size(); i += 6) x(i) = 0;
  });
  EXPECT_TRUE(says(text,
                   "Right in every column that is compared: y, theta, v_x, v_y and omega; wrong: "
                   "x."))
      << text;
  EXPECT_TRUE(says(text, "Zero in every column that is compared, after column 0: x.")) << text;
}

TEST(pattern, NamesTheColumnFromWhichATrajectoryIsZero) {
  const auto with = [](double last) {
    return told(4, [=](const Case&, auto& x) {
      x.tail(12).setZero();
      x(29) = last;
    });
  };
  EXPECT_TRUE(says(with(0), "The trajectory is right up to column 2, and 0 from column 3 on"));
  EXPECT_FALSE(says(with(1), "0 from column")) << with(1);
}

TEST(pattern, AsksWhetherAVelocityIsAColumnAhead) {
  const auto with = [](int in_place_of_2) {
    return told(4, [=](const Case&, auto& x) {
      x.segment(9, 3) = x.segment(15, 3).eval();
      x.segment(15, 3) = x.segment(6 * in_place_of_2 + 3, 3).eval();
    });
  };
  EXPECT_TRUE(
      says(with(3), "Your v in columns 1 and 2 is the right one of columns 2 and 3 in every"));
  EXPECT_FALSE(says(with(4), "ahead")) << with(4);
}

TEST(pattern, NamesTheStartOfATrajectory) {
  const std::string text =
      told(4, [](const Case& c, auto& x) { x.head(6) << c.q(2), c.q(1), c.q(0), c.v; });
  EXPECT_TRUE(says(text, "Your column 0 is q_0 in reverse order, and v_0 in every question."))
      << text;
}

TEST(pattern, NamesATrajectoryOfFloats) {
  const std::string text = told(
      4, [](const Case&, auto& x) { x = x.template cast<float>().template cast<double>().eval(); });
  EXPECT_TRUE(says(text, "right to six digits or more: is there a float?")) << text;
}

TEST(pattern, LeavesOutWhatIsNoNumberAndWhatThrew) {
  std::vector<Answer> got = right_answers(1);
  got[3] = {{}, "thrown"};
  got[4].numbers(6) = NAN;
  const auto told = patterns(1, some_cases(), right_answers(1), got);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(says(told[0], "Right in every public question that it answers: J_t"));
  EXPECT_TRUE(says(told[0], "wrong: phi."));
  EXPECT_TRUE(patterns(1, some_cases(), right_answers(1), {}).empty());
}

}  // namespace
}  // namespace bounce::tests
