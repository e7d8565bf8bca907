// What is said of wrong answers that no known mistake explains: each row makes all answers of a
// part wrong by a formula.
#include "../../parts/pattern.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <numbers>
#include <sstream>

#include "known_part.hpp"

namespace bounce::tests {
namespace {

using Q = const Case&;       // a question
using X = Eigen::VectorXd&;  // its right answer, in the numbers of answers.hpp, to be made wrong
using Formula = std::function<void(Q, X)>;
using Map4 = Eigen::Map<Eigen::Matrix4d>;

std::string told(int part, const Formula& formula) {
  const KnownPart& asked = known_part(part);
  std::vector<Answer> got = asked.known.right;
  for (std::size_t k = 0; k < got.size(); ++k) formula(asked.cases[k], got[k].numbers);
  std::string text;
  for (const auto& sentence : patterns(part, asked.cases, asked.known.right, got)) {
    text += sentence + "\n";
  }
  return text;
}

// --- formulas ---

void rounded_to_float(Q, X x) { x = x.cast<float>().cast<double>().eval(); }

void columns_exchanged(Q, X x) {
  Eigen::Map<Jacobian> J(x.data());
  J = J.rowwise().reverse().eval();
}

void filled_by_columns(Q, X x) {
  const Eigen::VectorXd old = x;
  x << old(0), old(3), old(1), old(4), old(2), old(5), old(6);
}

// From the centre to the lowest corner, by J of part 1.
Eigen::Vector2d arm(X x) { return {x(5), -x(2)}; }

void set_arm(Q c, X x, const Eigen::Vector2d& r) {
  x(2) = -r.y();
  x(5) = r.x();
  x(6) = c.q(1) + r.y();
}

Formula phi(double (*of)(Q, double)) {
  return [=](Q c, X x) { x(6) = of(c, x(6)); };
}

// As if the square had this angle and side.
Formula square(double (*angle)(Q), double (*side)(Q)) {
  return [=](Q c, X x) {
    Parameters params = c.params;
    params.l = side(c);
    x = numbers_of(get_contacts({c.q(0), c.q(1), angle(c)}, params));
  };
}

double angle_of(Q c) { return c.q(2); }
double side_of(Q c) { return c.params.l; }
double first_side(Q) { return known_part(1).cases[0].params.l; }

// In place of these corners, one that comes so many places after it.
Formula corner_in_place_of(const std::string& corners, int places) {
  return [=](Q c, X x) {
    const Eigen::Vector2d r = Eigen::Rotation2Dd(-c.q(2)) * arm(x);
    const char number = r.y() > 0 ? (r.x() > 0 ? '1' : '2') : (r.x() < 0 ? '3' : '4');
    if (corners.find(number) == std::string::npos) return;
    set_arm(c, x, Eigen::Rotation2Dd(places * std::numbers::pi / 2) * arm(x));
  };
}

void always_corner_2(Q c, X x) {
  for (const auto& [corner, places] : {std::pair("1", 1), {"3", 3}, {"4", 2}}) {
    corner_in_place_of(corner, places)(c, x);
  }
}

Formula written_pi(double pi) {
  return [=](Q c, X x) {
    const double quarters = std::floor(c.q(2) / std::numbers::pi * 4);
    set_arm(c, x, Eigen::Rotation2Dd(quarters * (pi - std::numbers::pi) / 4) * arm(x));
  };
}

// f_n last of the forces: in V, in its border, and in p, as far as asked.
Formula order_of_unknowns(bool border, bool p, double more = 0) {
  return [=](Q, X x) {
    const Eigen::Vector4i from(1, 2, 0, 3);
    const Eigen::VectorXd old = x;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        if (border || (i < 3 && j < 3)) x(i + 4 * j) = old(from(i) + 4 * from(j));
      }
      if (p) x(16 + i) = old(16 + from(i));
    }
    x(5) += more;
  };
}

Formula inertia(double factor, double more) {
  return [=](Q c, X x) {
    const double m = c.params.m, l = c.params.l;
    Eigen::Matrix3d J_hat;
    J_hat << c.J.col(1), -c.J.col(0), c.J.col(0);
    const Vector3 inverse(1 / m, 1 / m, 1 / (factor * m * l * l));
    Map4(x.data()).topLeftCorner<3, 3>() =
        J_hat.transpose() * inverse.asDiagonal() * J_hat * c.params.dt;
    x(0) += more;
  };
}

// An odd number is added to v_y' where the condition holds.
Formula wrong_where(bool (*condition)(Q)) {
  return [=](Q c, X x) { x(4) += condition(c) ? 3 + c.q(0) * c.v(0) : 0; };
}

bool corner_is(Q c, char number) {
  return c.corner.find(std::string("corner ") + number) != std::string::npos;
}

// The impulse of the forces in part 3: without gravity.
Vector3 impulse(Q c, X x) { return c.params.M() * (x.tail(3) - c.v - c.params.dt * c.params.g); }

Formula moment(double normal, double tangential) {
  return [=](Q c, X x) {
    const Vector3 f = impulse(c, x);
    const Contact contact = get_contacts(c.q, c.params);
    const double by_forces = normal * contact.J(2, 1) * f(1) - tangential * contact.J(2, 0) * f(0);
    x(5) = c.v(2) + c.params.dt * c.params.g(2) + by_forces / c.params.M()(2, 2);
  };
}

void friction_by_mu(Q c, X x) {
  const Vector3 f = impulse(c, x);
  const Contact contact = get_contacts(c.q, c.params);
  const Vector3 all = contact.J.col(1) * f(1) + contact.J.col(0) * f(0) * c.params.mu;
  x.tail(3) = c.v + c.params.dt * c.params.g + c.params.M().inverse() * all;
}

Formula from_column(Eigen::Index column, double factor, double last = 0) {
  return [=](Q, X x) {
    x.tail(x.size() - 6 * column) *= factor;
    x(x.size() - 1) += last;
  };
}

// The velocities of columns 1 and 2 are those of columns 2 and this one.
Formula velocity_ahead(Eigen::Index column) {
  return [=](Q, X x) {
    if (x.size() < 6 * column + 6) return;  // so short a trajectory
    x.segment(9, 3) = x.segment(15, 3).eval();
    x.segment(15, 3) = x.segment(6 * column + 3, 3).eval();
  };
}

// --- the table ---

constexpr const char* kNothing = "\n\n";  // which no text holds

struct Row {
  int part;
  Formula formula;
  const char* says;  // sentences, or their begin, between |; nullptr: nothing at all
  const char* never = kNothing;
};

const Row kRows[] = {
    {1, [](Q, X) {}, nullptr},
    {1, [](Q, X x) { x.setZero(); }, nullptr},
    {2, [](Q, X) {}, nullptr},
    // what is right, and what is wrong
    {1, [](Q c, X x) { x(2) += c.q(0) * c.q(2); },
     "Right in every public question: J_n and phi; wrong: J_t (third entry).", "only where"},
    {2, [](Q, X x) { x.segment(12, 4).setConstant(NAN); },
     "wrong: the last column of V and the last row of V (V(3, 3))."},
    // a factor, a difference, a constant
    {1, [](Q, X x) { x(0) = -x(0); }, "Every wrong number is -1 times the right one."},
    {1, [](Q c, X x) { x(6) *= c.params.m; }, "Every wrong number is m times the right one."},
    {3, [](Q, X x) { x.tail(3) *= 0.75; }, "Every wrong number is 0.75 times the right one."},
    {1,
     [](Q, X x) {
       x(0) = -x(0);
       x(6) *= 2;
     },
     "Every wrong number in J_t is -1 times the right one.|phi is 2 times the right one."},
    {3, [](Q, X x) { x.head(3) *= 4.04769e-15; }, "", "times"},
    {2, [](Q, X x) { x(16) += 0.5; }, "Every wrong number is 0.5 more than the right one."},
    {1, [](Q, X x) { x(2) = 7; }, "Every wrong number is 7, whatever the right one."},
    {2, [](Q, X x) { x(0) = INFINITY; },
     "Every wrong number is inf. Often: something is divided by 0"},
    {2, [](Q, X x) { x(0) = NAN; }, "Every wrong number is nan: was it ever set?"},
    {2, [](Q c, X x) { x(0) = c.v(0) > 0 ? NAN : INFINITY; },
     "Every wrong number is nan or inf: was it ever set?"},
    {2,
     [](Q c, X x) {
       x(16) *= c.v(0) < 0;
       x(17) += 1 + c.v(0) * c.v(0);
     },
     "Every wrong p(0) is 0, whatever the right one."},
    {1, [](Q, X x) { x(5) = 6.9e-310; }, "A number in an answer is 6.9e-310: was it ever set?"},
    {1, rounded_to_float, "is there a float"},
    {4, rounded_to_float, "right to six digits or more: is there a float?"},
    // exchanged places
    {1, columns_exchanged, "the two columns of J are exchanged"},
    {1, filled_by_columns, "J is filled column by column with what belongs into its rows"},
    {2, [](Q, X x) { Map4(x.data()).transposeInPlace(); }, "V is transposed"},
    {2, [](Q, X x) { std::swap(x(17), x(18)); }, "p(1) and p(2) are exchanged"},
    {2, order_of_unknowns(true, true), "V and p are in the order z = (f_t1, f_t2, f_n, lambda)"},
    {2, order_of_unknowns(true, false), "V is in the order z = (f_t1, f_t2, f_n, lambda), and p"},
    {2, order_of_unknowns(false, true), "lambda), and the border of V isn't."},
    {2, order_of_unknowns(true, true, 0.5), "", "in the order"},
    // formulas
    {2, inertia(1.0 / 12, 0), "dt with m l^2 / 12 for the inertia in every question."},
    {2, inertia(1.0 / 12, 0.01), "", "for the inertia"},
    {3, [](Q, X x) { x(4) = std::min(x(4), 0.5); }, "Your v_y' is min(0.5, v_y') in every"},
    {3, [](Q, X x) { x(4) = x(4) > 0.8 ? 0.6 : std::min(x(4), 0.5); }, "", "min("},
    {1, phi([](Q c, double) { return c.q(1); }),
     "Your phi is y, the height of the centre in every question.", "Where only"},
    {1, phi([](Q c, double) { return c.q(1) - c.params.l / 2; }),
     "Your phi is y - l/2 in every question."},
    {1, phi([](Q, double phi) { return std::abs(phi); }),
     "Your phi is the absolute value of phi in every question."},
    {1, phi([](Q, double phi) { return std::min(phi, 0.0); }), "", "Where only"},
    {1, phi([](Q c, double) {
       const double along = std::abs(std::cos(c.q(2))), aside = std::abs(std::sin(c.q(2)));
       return c.q(1) - c.params.l / 2 * std::max(along, aside);
     }),
     "the height of the middle of the lowest side"},
    {1, phi([](Q c, double phi) { return phi + c.q(2) * c.q(1); }), "", "Your phi is"},
    {1, [](Q, X x) { x.segment(3, 3).normalize(); },
     "Your J_n has the length 1 in every question."},
    {1, square([](Q c) { return c.q(2) / 2; }, side_of),
     "a square that is turned by theta / 2 in every question."},
    {1, square(angle_of, [](Q c) { return c.params.l / std::sqrt(8); }),
     "Your corner is l/4 away from the centre in every question"},
    {1, written_pi(3.14), "turned by a multiple of (3.14 - pi) / 4 in every question."},
    {1, written_pi(3.1416), "turned by a multiple of (3.1416 - pi) / 4 in every question."},
    {1, written_pi(3.15), "", "pi"},
    {3, [](Q c, X x) { x(5) = c.v(2) + (x(5) - c.v(2)) * c.params.l * c.params.l / 0.16; },
     "multiplied by (1, 1, l^2 / 0.16)."},
    {3, moment(1, -1), nullptr},
    {3, moment(1, 1), ", is r_x f_n + r_y f_t in every question."},
    {3, moment(-1, 0), ", is -r_x f_n in every question."},
    {3, moment(1, -0.5), "", "moment"},
    {3, friction_by_mu, "your v' is that with f_n multiplied by 1 and f_t by mu."},
    {3, [](Q c, X x) { x(2) = -c.params.dt * x(5); }, "Your theta' is theta in every question."},
    // corners
    {1, corner_in_place_of("4", 3), "Corner 4 is never chosen|Corners are numbered as in eq. (3)."},
    {1, corner_in_place_of("13", 3), "Corners 1 and 3 are never chosen"},
    {1, corner_in_place_of("1234", 3), "Your answer is always that of the leftmost corner."},
    {1, corner_in_place_of("134", 3), "", "leftmost"},
    {1, always_corner_2, "Your answer is always that of corner 2."},
    // where
    {2, [](Q c, X x) { x(0) += c.params.l == 0.2 ? 0 : 1 + c.v(0) * c.v(0); },
     "Wrong only where l isn't the assignment's, in all "},
    {2, [](Q c, X x) { x(0) += c.params.l == 0.2 || c.v(0) > 0 ? 0 : 1 + c.v(0) * c.v(0); }, "",
     "the assignment's"},
    {3, wrong_where([](Q c) { return corner_is(c, '2'); }), "Wrong only where corner 2 is the lo"},
    {3, wrong_where([](Q c) { return !corner_is(c, '2'); }), "Wrong only where corner 2 is not"},
    {3, wrong_where([](Q c) { return c.corner.find("sticks") != std::string::npos; }),
     "Wrong only where the corner sticks"},
    {3, wrong_where([](Q c) { return c.q(2) < 0; }), "Wrong only where theta is negative"},
    {3, wrong_where([](Q c) { return c.q(0) != known_part(3).cases[0].q(0); }), "", "only where"},
    {1, [](Q c, X x) { x(5) *= x(6) >= c.params.delta ? 3 : 1; }, "Wrong only where phi >= delta"},
    {1, [](Q c, X x) { x(5) *= x(6) >= c.params.delta || c.q(0) < 0 ? 3 : 1; }, "",
     "only where phi"},
    // inputs
    {1, square(angle_of, [](Q) { return 0.4; }),
     "Where only l is changed, J_t, J_n and phi stay the same in your answers, and they should "
     "change.",
     "kept"},
    {1, square(angle_of, first_side), "they should change: kept from an earlier call?"},
    {1, [](Q c, X x) { x(5) += c.q(0) * c.q(0); },
     "Where only x is changed, J_n changes in your answers, and it should stay the same."},
    {1, [](Q, X x) { std::swap(x(3), x(5)); }, "", "in your answers"},
    {1, [calls = 0](Q, X x) mutable { x(6) += ++calls; },
     "The same question, asked again after others, gets another answer"},
    // trajectories
    {4, from_column(0, 1.5), "Column 0 is the first wrong one in every case that is wrong."},
    {4, from_column(1, 1.5), "Column 1 is the first wrong one in every case that is wrong."},
    {4, from_column(3, 1.5), "Column 0 is right in every public question;"},
    {4, from_column(3, 0), "The trajectory is right up to column 2, and 0 from column 3 on"},
    {4, velocity_ahead(3),
     "Your v in columns 1 and 2 is the right one of columns 2 and 3 in every"},
    {4, velocity_ahead(4), "", "ahead"},
    {4, from_column(3, 0, 1), "", "0 from column"},
    {4,
     [](Q, X x) {
       for (Eigen::Index i = 6; i < x.size(); i += 6) x(i) = 0;
     },
     "Right in every column that is compared: y, theta, v_x, v_y and omega; wrong: x.|"
     "Zero in every column that is compared, after column 0: x."},
    {4, [](Q c, X x) { x.head(6) << c.q(2), c.q(1), c.q(0), c.v; },
     "Your column 0 is q_0 in reverse order, and v_0 in every question."},
};

TEST(pattern, SaysWhatIsTrueOfAllAnswersAndNothingElse) {
  for (const Row& row : kRows) {
    const std::string text = told(row.part, row.formula);
    const auto number = &row - kRows;
    std::istringstream says(row.says == nullptr ? "" : row.says);
    for (std::string words; std::getline(says, words, '|');) {
      EXPECT_NE(text.find(words), std::string::npos) << "row " << number << words << ":\n" << text;
    }
    EXPECT_EQ(text.find(row.never), std::string::npos) << "row " << number << ":\n" << text;
    EXPECT_EQ(text.empty(), row.says == nullptr) << "row " << number << ":\n" << text;
  }
}

TEST(pattern, LeavesOutWhatIsNoNumberAndWhatThrew) {
  const KnownPart& asked = known_part(1);
  std::vector<Answer> got = asked.known.right;
  got[3] = {{}, "thrown"};
  got[4].numbers(6) = NAN;
  const auto sentences = patterns(1, asked.cases, asked.known.right, got);
  ASSERT_FALSE(sentences.empty());
  EXPECT_EQ(sentences[0],
            "Right in every public question that it answers: J_t and J_n; wrong: phi.");
  EXPECT_TRUE(patterns(1, asked.cases, asked.known.right, {}).empty());
}

}  // namespace
}  // namespace bounce::tests
