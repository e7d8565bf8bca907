// The solvers: that they agree where all can, and where each of them fails.
#include <gtest/gtest.h>

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <limits>

#include "common.hpp"
#include "methods/gauss_seidel.hpp"
#include "methods/lemke.hpp"
#include "methods/one_corner.hpp"
#include "methods/two_corners.hpp"

namespace bounce::exact::tests {
namespace {

using methods::Arm;

struct Contact1 {
  Parameters params;
  Lcp lcp;
  methods::OneCorner<double> corner;
};

Contact1 random_contact(Random& random, double largest_mu, double m, double dt) {
  Contact1 contact;
  Parameters& params = contact.params;
  params.m = m;
  params.dt = dt;
  params.mu = random.uniform(0, largest_mu);
  params.epsilon = random.uniform(0, 1);
  const Vector3 v(random.uniform(-3, 3), -random.uniform(0.1, 2), random.uniform(-10, 10));
  const Jacobian J = get_contacts({0, 0.1, random.uniform(-4, 4)}, params).J;
  contact.lcp = form_lcp(J, v, params);
  contact.corner = methods::one_corner<double>({J(2, 1), -J(2, 0)}, params.l * params.l / 6,
                                               contact.lcp.p(0), contact.lcp.p(2), params.mu);
  return contact;
}

// How far the forces (f_n, f_t1, f_t2) are from the closed form's impulses, relatively.
double off(const Contact1& contact, const Eigen::VectorXd& f) {
  const auto p = methods::solve_one_corner(contact.corner);
  const double scale = contact.params.dt / contact.params.m;
  const double error = std::hypot(f(0) * scale - p.n, (f(2) - f(1)) * scale - p.t);
  return error / std::max(std::hypot(p.n, p.t), 1e-3);
}

TEST(solvers, AgreeOnOneCorner) {
  Random random(1);
  for (int i = 0; i < 10'000; ++i) {
    const Contact1 contact = random_contact(random, 1.2, 0.3, 0.01);
    ASSERT_LE(off(contact, solve_lcp(contact.lcp.V, contact.lcp.p)), 1e-10) << i;
    ASSERT_LE(off(contact, methods::lemke(contact.lcp.V, contact.lcp.p).z), 1e-9) << i;
    const auto& k = contact.corner;
    Eigen::Matrix2d G;
    G << k.a, k.b, k.b, k.c;
    const auto p = methods::solve_one_corner(k);
    const auto swept =
        methods::gauss_seidel(G, Eigen::Vector2d(k.u_n, k.u_t), k.mu, 1e-13, 100'000);
    ASSERT_TRUE(swept.converged) << i;
    ASSERT_NEAR(swept.p(0), p.n, 1e-9 * (1 + p.n)) << i;
    ASSERT_NEAR(swept.p(1), p.t, 1e-9 * (1 + p.n)) << i;
  }
}

Jacobian jacobian(const Arm<double>& r) {
  Jacobian J;
  J << Vector3(1, 0, -r.y), Vector3(0, 1, r.x);
  return J;
}

struct Side {
  methods::Lcp8 lcp;
  methods::SideImpulse<double> merged;
  Vector3 v_literal, v_merged;  // after the contact
};

Side side_at(double theta, const Vector3& v, const Parameters& params,
             methods::LemkeResult* result) {
  const auto r = methods::arms(params.l / 2, std::cos(theta), std::sin(theta));
  const Jacobian J_1 = jacobian(r[2]), J_2 = jacobian(r[3]);
  Side side{methods::form_lcp8(J_1, J_2, v, params), {}, {}, {}};
  const Eigen::VectorXd& p = side.lcp.p;
  side.merged = methods::solve_two_corners(methods::two_corners<double>(
      r[2], r[3], params.l * params.l / 6, {p(0), p(4)}, (p(2) + p(6)) / 2, params.mu));
  *result = methods::lemke(side.lcp.V, p);
  const Eigen::VectorXd& z = result->z;
  const Vector3 free = v + params.dt * params.g;
  side.v_literal = free + params.dt * params.M().inverse() *
                              (J_1.col(1) * z(0) + J_1.col(0) * (z(2) - z(1)) + J_2.col(1) * z(4) +
                               J_2.col(0) * (z(6) - z(5)));
  methods::Motion<double> s{0, 0, 0, free.x(), free.y(), free.z()};
  for (int i = 0; i < 2; ++i)
    methods::apply_impulse(s, r[2 + i], side.merged.n[i], side.merged.t / 2,
                           params.l * params.l / 6);
  side.v_merged = {s.v_x, s.v_y, s.omega};
  return side;
}

TEST(solvers, MergedFrictionRowsAreTheEightByEightOfAFlatSide) {
  Random random(2);
  const Parameters params;
  for (int i = 0; i < 5000; ++i) {
    const Vector3 v(random.uniform(-2, 2), -random.uniform(0, 4), random.uniform(-20, 20));
    methods::LemkeResult result;
    const Side side = side_at(0, v, params, &result);
    ASSERT_EQ(result.end, methods::LemkeEnd::solved);
    ASSERT_LE((side.v_literal - side.v_merged).norm(), 1e-10) << i;
  }
}

TEST(solvers, AnAlmostFlatSideMakesTheEightByEightSaySolvedWhereItIsNot) {
  methods::LemkeResult result;
  const Vector3 v(0.67769883376658191, -0.23737549828107207, 19.956074175907368);
  const Side side = side_at(4.2195760913384079e-12, v, Parameters(), &result);
  EXPECT_EQ(result.end, methods::LemkeEnd::solved);
  EXPECT_GT(methods::lcp_residual(side.lcp.V, side.lcp.p, result.z), 0.5) << "m/s";
  EXPECT_LE(side.merged.violation, 1e-15);
}

TEST(solvers, AnAlmostFlatSideIsNoTroubleForMergedFrictionRows) {
  Random random(3);
  for (int digits = 3; digits <= 16; ++digits) {
    for (int i = 0; i < 500; ++i) {
      methods::LemkeResult result;
      const Vector3 v(random.uniform(-2, 2), -random.uniform(0, 4), random.uniform(-20, 20));
      const Side side = side_at(std::pow(10.0, -digits), v, Parameters(), &result);
      ASSERT_LE(side.merged.violation, 1e-13) << digits << " " << i;
    }
  }
}

int sweeps_for_mass_ratio(double R) {
  Eigen::Matrix4d G = Eigen::Matrix4d::Identity();
  G(0, 2) = G(2, 0) = -1;
  G(2, 2) = 1 + 1 / R;
  return methods::gauss_seidel(G, Eigen::Vector4d(-0.1, 0, 0, 0), 0, 1e-10, 1'000'000).sweeps;
}

TEST(solvers, GaussSeidelNeedsSweepsInProportionToTheMassRatio) {
  for (const double R : {10.0, 100.0, 1000.0}) {
    const double predicted = std::log(1e-9) / std::log(R / (1 + R));
    EXPECT_NEAR(sweeps_for_mass_ratio(R), predicted, 2 + predicted / 100);
  }
}

TEST(solvers, GaussSeidelRunsInCirclesOnOneCornerAtMuTwo) {
  Random random(4);
  int endless = 0, endless_below = 0;
  for (int i = 0; i < 500; ++i) {
    for (const double mu : {1.2, 2.0}) {
      const double alpha = random.uniform(-0.78, 0.78);
      const auto k =
          methods::one_corner<double>({std::sin(alpha), -std::cos(alpha)}, 1.0 / 3,
                                      -random.uniform(0.1, 1), random.uniform(-3, 3), mu);
      Eigen::Matrix2d G;
      G << k.a, k.b, k.b, k.c;
      const auto swept = methods::gauss_seidel(G, Eigen::Vector2d(k.u_n, k.u_t), mu, 1e-9, 10'000);
      (mu > 4.0 / 3 ? endless : endless_below) += !swept.converged;
    }
  }
  EXPECT_GT(endless, 50);
  EXPECT_EQ(endless_below, 0) << "a > mu |b| for every angle";
}

TEST(solvers, TheClosedFormHasAnAnswerWhereGaussSeidelHasNone) {
  Random random(5);
  for (int i = 0; i < 20'000; ++i) {
    const double alpha = random.uniform(-0.78, 0.78);
    const auto k = methods::one_corner<double>({std::sin(alpha), -std::cos(alpha)}, 1.0 / 3,
                                               -random.uniform(0.1, 1), random.uniform(-3, 3), 2);
    const auto p = methods::solve_one_corner(k);
    const double v_n = k.a * p.n + k.b * p.t + k.u_n, v_t = k.b * p.n + k.c * p.t + k.u_t;
    ASSERT_GE(p.n, 0) << i;
    ASSERT_NEAR(v_n, 0, 1e-12 * (1 + p.n)) << i;
    ASSERT_LE(std::abs(p.t), k.mu * p.n * (1 + 1e-14)) << i;
    ASSERT_LE(p.t * v_t, 1e-12 * (1 + p.n * p.n)) << i << ": friction opposes sliding";
  }
}

TEST(solvers, GaussSeidelIsUndefinedOnTheLiteralFourByFour) {
  Random random(6);
  const Contact1 contact = random_contact(random, 1, 0.3, 0.01);
  EXPECT_EQ(contact.lcp.V(3, 3), 0);
  EXPECT_FALSE(methods::gauss_seidel_lcp(contact.lcp.V, contact.lcp.p, 1e-9, 100).has_value());
}

TEST(solvers, PlainPivotingFailsAtExtremeMassesAndImpulsesDoNot) {
  Random random(7);
  for (const double m : {1e-12, 1e12}) {
    int wrong = 0;
    for (int i = 0; i < 200; ++i) {
      const Contact1 contact = random_contact(random, 1.2, m, m < 1 ? 1e-6 : 0.01);
      const double error = off(contact, methods::lemke(contact.lcp.V, contact.lcp.p).z);
      wrong += !(error <= 1e-6);
      ASSERT_LE(off(contact, solve_lcp(contact.lcp.V, contact.lcp.p)), 1e-9) << "scaled first";
    }
    EXPECT_GT(wrong, 100) << "m = " << m;
  }
}

TEST(solvers, LetNanThroughAsNanAndNotAsAnAnswer) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto p = methods::solve_one_corner<double>({2, 0.5, 3, nan, 1, 0.3});
  EXPECT_TRUE(std::isnan(p.n) && std::isnan(p.t));
  const auto side = methods::solve_two_corners(
      methods::two_corners<double>({-0.1, -0.1}, {0.1, -0.1}, 0.04 / 6, {nan, -1}, 0, 0.3));
  EXPECT_FALSE(side.violation <= 1);
  EXPECT_EQ(std::max(0.0, nan), 0.0) << "how a NaN is hidden";
  Eigen::Vector4d p_nan(nan, nan, nan, nan);
  EXPECT_FALSE(methods::lcp_residual(Eigen::Matrix4d::Identity(), p_nan,
                                     methods::lemke(Eigen::Matrix4d::Identity(), p_nan).z) <= 1)
      << "whatever a solver says of NaN, the residual tells";
}

}  // namespace
}  // namespace bounce::exact::tests
