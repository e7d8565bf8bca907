// What is said of wrong answers that no known mistake explains: each row makes all answers of a
// part wrong by a formula.
#include "../../../grader/diagnosis/pattern.hpp"

#include <Eigen/Geometry>
#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <numbers>

#include "expected_texts.hpp"
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

double odd(Q c) { return 1 + c.v(0) * c.v(0); }

void zero_or_more(Q c, X x) {
  x(16) *= c.v(0) < 0;
  x(17) += odd(c);
}

void usual_gravity(Q c, X x) { x(16) += c.params.dt * c.J.col(1).dot(Parameters().g - c.params.g); }

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

double lowest_middle(Q c, double) {
  const double along = std::abs(std::cos(c.q(2))), aside = std::abs(std::sin(c.q(2)));
  return c.q(1) - c.params.l / 2 * std::max(along, aside);
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
Q first(int part) { return known_part(part).cases[0]; }

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

void x_left_zero(Q, X x) {
  for (Eigen::Index i = 6; i < x.size(); i += 6) x(i) = 0;
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

struct Row {
  const char* name;
  int part;
  Formula formula;
};

const Row kRows[] = {
    {"all right, part 1", 1, [](Q, X) {}},
    {"all zeros", 1, [](Q, X x) { x.setZero(); }},
    // what is right, and what is wrong
    {"one entry", 1, [](Q c, X x) { x(2) += c.q(0) * c.q(2); }},
    {"a column and a row", 2, [](Q, X x) { x.segment(12, 4).setConstant(NAN); }},
    // a factor, a difference, a constant
    {"times -1", 1, [](Q, X x) { x(0) = -x(0); }},
    {"times m", 1, [](Q c, X x) { x(6) *= c.params.m; }},
    {"no factor: rounding", 3, [](Q, X x) { x.head(3) *= 4.04769e-15; }},
    {"0.5 more", 2, [](Q, X x) { x(16) += 0.5; }},
    {"always 7", 1, [](Q, X x) { x(2) = 7; }},
    {"always nan", 2, [](Q, X x) { x(0) = NAN; }},
    {"nan or infinite", 2, [](Q c, X x) { x(0) = c.v(0) > 0 ? NAN : INFINITY; }},
    {"sometimes 0, and more", 2, zero_or_more},
    {"where it comes down", 2, [](Q c, X x) { x(16) += c.J.col(1).dot(c.v) < 0 ? odd(c) : 0; }},
    {"never set", 1, [](Q, X x) { x(5) = 6.9e-310; }},
    {"floats", 1, rounded_to_float},
    {"floats, part 4", 4, rounded_to_float},
    // exchanged places
    {"columns exchanged", 1, columns_exchanged},
    {"filled by columns", 1, filled_by_columns},
    {"transposed", 2, [](Q, X x) { Map4(x.data()).transposeInPlace(); }},
    {"entries of p exchanged", 2, [](Q, X x) { std::swap(x(17), x(18)); }},
    {"f_n last", 2, order_of_unknowns(true, true)},
    {"f_n last in V", 2, order_of_unknowns(true, false)},
    {"f_n last, but not in the border", 2, order_of_unknowns(false, true)},
    {"f_n last, and more", 2, order_of_unknowns(true, true, 0.5)},
    // formulas
    {"a twelfth", 2, inertia(1.0 / 12, 0)},
    {"a twelfth, and more", 2, inertia(1.0 / 12, 0.01)},
    {"at most 0.5", 3, [](Q, X x) { x(4) = std::min(x(4), 0.5); }},
    {"phi of the centre", 1, phi([](Q c, double) { return c.q(1); })},
    {"phi of a flat square", 1, phi([](Q c, double) { return c.q(1) - c.params.l / 2; })},
    {"the absolute value", 1, phi([](Q, double phi) { return std::abs(phi); })},
    {"at most 0", 1, phi([](Q, double phi) { return std::min(phi, 0.0); })},
    {"phi of a side's middle", 1, phi(lowest_middle)},
    {"the corner's x", 1, [](Q c, X x) { x(6) = c.q(0) + x(5); }},
    {"x + r_y", 1, [](Q c, X x) { x(6) = c.q(0) - x(2); }},
    {"y + r_x", 1, [](Q c, X x) { x(6) = c.q(1) + x(5); }},
    {"the highest corner's y", 1, [](Q c, X x) { x(6) = c.q(1) + x(2); }},
    {"phi with more", 1, phi([](Q c, double phi) { return phi + c.q(2) * c.q(1); })},
    {"J_n of length 1", 1, [](Q, X x) { x.segment(3, 3).normalize(); }},
    {"half the angle", 1, square([](Q c) { return c.q(2) / 2; }, side_of)},
    {"a small square", 1, square(angle_of, [](Q c) { return c.params.l / std::sqrt(8); })},
    {"pi = 3.14", 1, written_pi(3.14)},
    {"pi = 3.15", 1, written_pi(3.15)},
    {"the right moment", 3, moment(1, -1)},
    {"a sign in the moment", 3, moment(1, 1)},
    {"no friction in the moment", 3, moment(-1, 0)},
    {"half the friction in the moment", 3, moment(1, -0.5)},
    {"friction by mu", 3, friction_by_mu},
    {"theta stays", 3, [](Q c, X x) { x(2) = -c.params.dt * x(5); }},
    // corners
    {"never corner 4", 1, corner_in_place_of("4", 3)},
    {"never corners 1 and 3", 1, corner_in_place_of("13", 3)},
    {"the leftmost", 1, corner_in_place_of("1234", 3)},
    {"three of the leftmost", 1, corner_in_place_of("134", 3)},
    {"always corner 2", 1, always_corner_2},
    // where
    {"another l", 2, [](Q c, X x) { x(0) += c.params.l == 0.2 ? 0 : odd(c); }},
    {"another l, or more", 2,
     [](Q c, X x) { x(0) += c.params.l == 0.2 || c.v(0) > 0 ? 0 : odd(c); }},
    {"corner 2 is lowest", 3, wrong_where([](Q c) { return corner_is(c, '2'); })},
    {"corner 2 is not", 3, wrong_where([](Q c) { return !corner_is(c, '2'); })},
    {"it sticks", 3, wrong_where([](Q c) { return c.corner.find("sticks") != c.corner.npos; })},
    {"theta < 0", 3, wrong_where([](Q c) { return c.q(2) < 0; })},
    {"all but the first", 3, wrong_where([](Q c) { return c.q(0) != first(3).q(0); })},
    {"phi >= delta", 1, [](Q c, X x) { x(5) *= x(6) >= c.params.delta ? 3 : 1; }},
    {"phi >= delta, or more", 1,
     [](Q c, X x) { x(5) *= x(6) >= c.params.delta || c.q(0) < 0 ? 3 : 1; }},
    // inputs
    {"l is 0.4", 1, square(angle_of, [](Q) { return 0.4; })},
    {"l is the first", 1, square(angle_of, [](Q) { return first(1).params.l; })},
    {"g along J_n is the usual", 2, usual_gravity},
    {"x counts", 1, [](Q c, X x) { x(5) += c.q(0) * c.q(0); }},
    {"entries exchanged", 1, [](Q, X x) { std::swap(x(3), x(5)); }},
    {"another answer each time", 1, [calls = 0](Q, X x) mutable { x(6) += ++calls; }},
    // trajectories
    {"wrong from column 0", 4, from_column(0, 1.5)},
    {"wrong from column 1", 4, from_column(1, 1.5)},
    {"wrong from column 3", 4, from_column(3, 1.5)},
    {"0 from column 3", 4, from_column(3, 0)},
    {"0 from column 3, but the last", 4, from_column(3, 0, 1)},
    {"v a column early", 4, velocity_ahead(3)},
    {"v two columns early", 4, velocity_ahead(4)},
    {"x is 0", 4, x_left_zero},
    {"q_0 in reverse", 4, [](Q c, X x) { x.head(6) << c.q(2), c.q(1), c.q(0), c.v; }},
};

TEST(pattern, SaysWhatIsTrueOfAllAnswersAndNothingElse) {
  Texts texts;
  for (const Row& row : kRows) texts.emplace_back(row.name, told(row.part, row.formula));
  expect_texts("patterns.txt", texts);
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
