#include "part2.hpp"
#include <cmath>

namespace slips {
namespace {

Vector3 inertia(const Parameters& p) {
  double I = p.m * p.l * p.l / 6;
  if (slip("inertia l^2/12")) I /= 2;
  if (slip("inertia l^2/3")) I *= 2;
  if (slip("inertia l^2/8, a disc")) I *= 6.0 / 8;
  if (slip("inertia 2/5 l^2")) I *= 6.0 * 2 / 5;
  if (slip("inertia of a point, m l^2")) I *= 6;
  if (slip("inertia m l^2/2")) I *= 3;
  if (slip("r_g not squared")) I = p.m * p.l / std::sqrt(6);
  if (slip("inertia m l/6")) I = p.m * p.l / 6;
  if (slip("inertia without m")) I = p.l * p.l / 6;
  if (slip("inertia is m")) I = p.m;
  if (slip("inertia 0.3 0.2^2/6 written down")) I = 0.3 * 0.04 / 6;
  Vector3 M(p.m, p.m, I);
  if (slip("M kept from the first call")) {
    auto& kept = program().kept["M"];
    if (!kept.size()) kept = M;
    M = kept;
  }
  return M;
}

// What takes the place of M^-1 in V and in p.
Vector3 inverse_in_V(const Vector3& M) {
  Vector3 inverse = M.cwiseInverse();
  if (slip("M in place of its inverse in V") || slip("M in place of its inverse everywhere"))
    inverse = M;
  if (slip("inverse of M left out of V") || slip("inverse of M left out everywhere"))
    inverse.setOnes();
  if (slip("1/m for all three in V")) inverse.setConstant(1 / M(0));
  if (slip("inertia's inverse forgotten in V")) inverse(2) = M(2);
  return inverse;
}
Vector3 acceleration(const Vector3& M, const Parameters& p) {
  Vector3 f = M.cwiseProduct(p.g);
  if (slip("f_e = g")) f = p.g;
  if (slip("f_e = -M g")) f = -f;
  if (slip("f_e = 0")) f.setZero();
  if (slip("f_e twice")) f *= 2;
  Vector3 inverse = M.cwiseInverse();
  if (slip("M in place of its inverse in p") || slip("M in place of its inverse everywhere"))
    inverse = M;
  if (slip("inverse of M left out of p") || slip("inverse of M left out everywhere"))
    inverse.setOnes();
  return f.cwiseProduct(inverse);
}

struct Blocks {
  double v_n, v_t, g_n, g_t;
};
Eigen::Vector4d p_of(const Blocks& b, const Parameters& P) {
  const double dt = slip("dt left out of p") ? 1 : slip("dt^2 in p") ? P.dt * P.dt : P.dt;
  double e = 1 + P.epsilon;
  if (slip("epsilon in place of 1 + epsilon")) e = P.epsilon;
  if (slip("1 - epsilon in place of 1 + epsilon")) e = 1 - P.epsilon;
  if (slip("no restitution")) e = 1;
  if (slip("-epsilon in place of 1 + epsilon")) e = -P.epsilon;
  if (slip("1 + epsilon only for what approaches") && b.v_n > 0) e = 1;
  if (slip("1 + epsilon only for what approaches faster than 1") && b.v_n > -1) e = 1;
  if (slip("epsilon squared")) e = 1 + P.epsilon * P.epsilon;
  double p0 = e * b.v_n + dt * b.g_n;
  if (slip("1 + epsilon on gravity too")) p0 = e * (b.v_n + dt * b.g_n);
  if (slip("1 + epsilon on gravity alone")) p0 = b.v_n + e * dt * b.g_n;
  if (slip("no gravity in the normal row")) p0 -= dt * b.g_n;
  if (slip("sign of gravity in the normal row")) p0 -= 2 * dt * b.g_n;
  if (slip("no velocity in the normal row")) p0 -= e * b.v_n;
  double et =
      slip("1 + epsilon in the tangential rows") || slip("1 + epsilon in every row, gravity too")
          ? 1 + P.epsilon
          : 1;
  if (slip("1 - mu in the tangential rows")) et = 1 - P.mu;
  double gt = slip("no gravity in the tangential rows") ? 0 : dt * b.g_t;
  if (slip("1 + epsilon in every row, gravity too")) {
    gt *= 1 + P.epsilon;
    p0 = (1 + P.epsilon) * (b.v_n + dt * b.g_n);
  }
  double p1 = -(et * b.v_t + gt), p2 = et * b.v_t + gt;
  if (slip("plus before the gravity of p(1)")) p1 += 2 * gt;
  if (slip("minus before the gravity of p(2)")) p2 -= 2 * gt;
  if (slip("sign of p(1)")) p1 = -p1;
  if (slip("sign of p(2)")) p2 = -p2;
  if (slip("sign of p(0)")) p0 = -p0;
  if (slip("p(1) and p(2) exchanged")) std::swap(p1, p2);
  if (slip("normal row of p second, order t1 n t2")) std::swap(p0, p1);
  if (slip("normal velocity in the tangential rows")) {
    p1 = -b.v_n - dt * b.g_n;
    p2 = b.v_n + dt * b.g_n;
  }
  if (slip("absolute value of the sliding velocity")) {
    p1 = -std::fabs(b.v_t + gt);
    p2 = -p1;
  }
  if (slip("p(2) left at 0")) p2 = 0;
  Eigen::Vector4d p(p0, p1, p2, 0);
  if (slip("p all negated")) p = -p;
  if (slip("mu in p(3)")) p(3) = P.mu;
  if (slip("1 in p(3)")) p(3) = 1;
  if (slip("p divided by dt")) p /= P.dt;
  if (slip("p is a float")) p = p.cast<float>().cast<double>();
  if (slip("p multiplied by m")) p *= P.m;
  if (slip("p is left at zero")) p.setZero();
  if (slip("gravity added to every entry of p")) p.head<3>().array() += dt * b.g_n;
  return p;
}

void border(Eigen::Matrix4d& V, const Parameters& P) {
  V.col(3) << 0, 1, 1, 0;
  V.row(3) << P.mu, -1, -1, 0;
  if (slip("last row mu 1 1 0")) V.row(3) << P.mu, 1, 1, 0;
  if (slip("last row 1 -1 -1 0")) V.row(3) << 1, -1, -1, 0;
  if (slip("last row 1 -mu -mu 0")) V.row(3) << 1, -P.mu, -P.mu, 0;
  if (slip("last row 0 -1 -1 0")) V.row(3) << 0, -1, -1, 0;
  if (slip("last row mu -mu -mu 0")) V.row(3) << P.mu, -P.mu, -P.mu, 0;
  if (slip("last row -mu 1 1 0")) V.row(3) << -P.mu, 1, 1, 0;
  if (slip("last row -mu -1 -1 0")) V.row(3) << -P.mu, -1, -1, 0;
  if (slip("last row mu -1 1 0")) V.row(3) << P.mu, -1, 1, 0;
  if (slip("last row 2 mu")) V.row(3) << 2 * P.mu, -1, -1, 0;
  if (slip("last row zero")) V.row(3).setZero();
  if (slip("last row mu -1 0 0")) V.row(3) << P.mu, -1, 0, 0;
  if (slip("V(3,3) = 1")) V(3, 3) = 1;
  if (slip("last column 1 1 0 0")) V.col(3) << 1, 1, 0, 0;
  if (slip("last column 1 1 1 0")) V.col(3) << 1, 1, 1, 0;
  if (slip("last column 0 -1 -1 0")) V.col(3) << 0, -1, -1, 0;
  if (slip("last column zero")) V.col(3).setZero();
  if (slip("last column 0 1 0 0")) V.col(3) << 0, 1, 0, 0;
  if (slip("last column 0 1 1 1")) V.col(3) << 0, 1, 1, 1;
  if (slip("last column 0 dt dt 0")) V.col(3) << 0, P.dt, P.dt, 0;
  if (slip("last row times dt")) V.row(3) *= P.dt;
  if (slip("row and column of lambda exchanged")) {
    const Eigen::Vector4d c = V.col(3);
    V.col(3) = V.row(3).transpose().eval();
    V.row(3) = c.transpose();
  }
  if (slip("V transposed")) V.transposeInPlace();
  if (slip("V all negative")) V = -V;
  if (slip("V is left at zero")) V.setZero();
  if (slip("V is symmetric, last row 0 1 1 0")) V.row(3) << 0, 1, 1, 0;
}
double step_in_V(const Parameters& P) {
  if (slip("dt left out of V")) return 1;
  if (slip("dt^2 in V")) return P.dt * P.dt;
  if (slip("dt divides V")) return 1 / P.dt;
  if (slip("dt/2 in V")) return P.dt / 2;
  return P.dt;
}
const std::string names = "lmuegd";

Blocks blocks(const Jacobian& J, const Vector3& v, const Vector3& a) {
  return {J.col(1).dot(v), J.col(0).dot(v), J.col(1).dot(a), J.col(0).dot(a)};
}

Lcp matrix(const Jacobian& J, const Vector3& v, const Parameters& given) {
  const Parameters P = with_parameter_slips(given, names);
  const Vector3 M = inertia(P);
  Eigen::Matrix3d H;
  H << J.col(1), -J.col(0), J.col(0);
  if (slip("J_hat = [J_n J_t J_t]")) H << J.col(1), J.col(0), J.col(0);
  if (slip("J_hat = [J_n J_t -J_t]")) H << J.col(1), J.col(0), -J.col(0);
  if (slip("J_hat = [J_t -J_n J_n]")) H << J.col(0), -J.col(1), J.col(1);
  if (slip("J_hat = [-J_n -J_t J_t]")) H << -J.col(1), -J.col(0), J.col(0);
  if (slip("J_hat = [-J_t J_t J_n]")) H << -J.col(0), J.col(0), J.col(1);
  if (slip("J_hat = [J_n -J_t -J_t]")) H << J.col(1), -J.col(0), -J.col(0);
  if (slip("J_hat stacked as rows")) {
    H.row(0) = J.col(1);
    H.row(1) = -J.col(0);
    H.row(2) = J.col(0);
  }
  const Vector3 inverse = inverse_in_V(M);
  Eigen::Matrix3d A = H.transpose() * inverse.asDiagonal() * H * step_in_V(P);
  if (slip("J_hat M^-1 J_hat^T")) A = H * inverse.asDiagonal() * H.transpose() * step_in_V(P);
  if (slip("J_hat not transposed")) A = H * inverse.asDiagonal() * H * step_in_V(P);
  if (slip("M^-1 on the wrong side")) A = inverse.asDiagonal() * H.transpose() * H * step_in_V(P);
  if (slip("block negative")) A = -A;
  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  V.topLeftCorner<3, 3>() = A;
  border(V, P);
  Blocks b = blocks(J, v, acceleration(M, P));
  if (slip("J_hat of V in p too"))
    b = blocks((Jacobian() << H.col(2), H.col(0)).finished(), v, acceleration(M, P));
  return {V, p_of(b, P)};
}

Lcp written(const Jacobian& J, const Vector3& v, const Parameters& given) {
  const Parameters P = with_parameter_slips(given, names);
  const Vector3 M = inertia(P), w = inverse_in_V(M);
  Vector3 t = J.col(0), n = J.col(1);
  if (slip("J_t and J_n exchanged")) std::swap(t, n);
  const double dt = step_in_V(P);
  const auto product = [&](const Vector3& a, const Vector3& b, const std::string& at) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      if (slip("term " + std::to_string(i) + " left out of " + at)) continue;
      sum += a(i) * b(i) * w(i);
    }
    return sum;
  };
  double nn = product(n, n, "J_n M^-1 J_n"), nt = product(n, t, "J_n M^-1 J_t"),
         tt = product(t, t, "J_t M^-1 J_t");
  if (slip("J_t for J_n in V(0,0)")) nn = tt;
  if (slip("J_n for J_t in the friction block")) tt = nn;
  if (slip("coupling of n and t left out")) nt = 0;
  if (slip("1/m alone for V(0,0)")) nn = w(0);
  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  V.topLeftCorner<3, 3>() << nn, -nt, nt, -nt, tt, -tt, nt, -tt, tt;
  V *= dt;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const std::string at = "V(" + std::to_string(i) + "," + std::to_string(j) + ")";
      if (slip("sign of " + at)) V(i, j) = -V(i, j);
      if (slip("dt forgotten in " + at)) V(i, j) /= dt;
      if (slip(at + " forgotten")) V(i, j) = 0;
    }
  if (slip("signs of the first row of the block")) {
    V(0, 1) = -V(0, 1);
    V(0, 2) = -V(0, 2);
  }
  border(V, P);
  return {V, p_of(blocks((Jacobian() << t, n).finished(), v, acceleration(M, P)), P)};
}

Lcp loops(const Jacobian& J, const Vector3& v, const Parameters& given) {
  const Parameters P = with_parameter_slips(given, names);
  const Vector3 M = inertia(P), w = inverse_in_V(M), a = acceleration(M, P);
  double d[3][3];
  for (int i = 0; i < 3; ++i) {
    d[0][i] = J(i, 1);
    d[1][i] = -J(i, 0);
    d[2][i] = J(i, 0);
  }
  if (slip("theta row of J_hat forgotten"))
    for (auto& row : d) row[2] = 0;
  if (slip("y row of J_hat forgotten"))
    for (auto& row : d) row[1] = 0;
  if (slip("J(0,1) read as J(1,0)")) {
    for (int i = 0; i < 3; ++i) {
      d[0][i] = J.data()[2 * i + 1];
      d[2][i] = J.data()[2 * i];
      d[1][i] = -d[2][i];
    }
  }
  const int terms = slip("sum stops before theta") ? 2 : 3;
  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < terms; ++k) V(i, j) += d[i][k] * w(k) * d[j][k] * step_in_V(P);
  if (slip("diagonal of V alone"))
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (i != j) V(i, j) = 0;
  if (slip("lower triangle left at 0")) V(1, 0) = V(2, 0) = V(2, 1) = 0;
  border(V, P);
  Blocks b{};
  for (int k = 0; k < 3; ++k) {
    b.v_n += d[0][k] * v(k);
    b.v_t += d[2][k] * v(k);
    b.g_n += d[0][k] * a(k);
    b.g_t += d[2][k] * a(k);
  }
  if (slip("sum of p stops before theta")) {
    b.v_n -= d[0][2] * v(2);
    b.v_t -= d[2][2] * v(2);
    b.g_n -= d[0][2] * a(2);
    b.g_t -= d[2][2] * a(2);
  }
  Eigen::Vector4d p = p_of(b, P);
  if (slip("phi/dt added to p(0)")) p(0) += 0.0005 / P.dt;
  return {V, p};
}
}  // namespace

const std::map<std::string, FormLcp>& part2_styles() {
  static const std::map<std::string, FormLcp> styles{
      {"matrix", matrix}, {"written out", written}, {"loop", loops}};
  return styles;
}
}  // namespace slips
