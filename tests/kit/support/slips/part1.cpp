#include "part1.hpp"
#include <array>
#include <complex>
#include <numbers>

namespace slips {
namespace {
constexpr double pi = std::numbers::pi;

double angle(const Vector3& q) {
  double theta = q(2);
  if (slip("theta taken as degrees, turned to radians")) theta *= pi / 180;
  if (slip("theta turned to degrees")) theta *= 180 / pi;
  if (slip("q(0) as the angle")) theta = q(0);
  if (slip("q(1) as the angle")) theta = q(1);
  if (slip("theta turns the wrong way")) theta = -theta;
  if (slip("theta unused")) theta = 0;
  if (slip("theta modulo pi/2")) theta = std::fmod(theta, pi / 2);
  if (slip("theta modulo pi")) theta = std::fmod(theta, pi);
  if (slip("absolute value of theta")) theta = std::fabs(theta);
  if (slip("theta modulo 2 pi without its sign")) theta = std::fabs(std::fmod(theta, 2 * pi));
  if (slip("theta modulo 360")) theta = std::fmod(theta, 360);
  if (slip("theta modulo 2 * 3.14")) theta = std::fmod(theta, 6.28);
  if (slip("theta is a float")) theta = static_cast<float>(theta);
  if (slip("theta is an int")) theta = static_cast<int>(theta);
  return theta;
}

// r and height of the chosen corner to J and phi.
Contact finish(const Vector3& q, const Parameters& params, double rx, double ry, double height) {
  double phi = height;
  if (slip("phi as height of the centre above the corner")) phi = q(1) - height;
  if (slip("phi = q(1)")) phi = q(1);
  if (slip("phi = y - l/2")) phi = q(1) - params.l / 2;
  if (slip("phi = y - half diagonal")) phi = q(1) - params.l / std::sqrt(2);
  if (slip("phi = y - l")) phi = q(1) - params.l;
  if (slip("phi clamped at 0")) phi = std::max(0.0, phi);
  if (slip("phi with the other sign")) phi = -phi;
  if (slip("absolute value of phi")) phi = std::fabs(phi);
  if (slip("phi = r_y, centre forgotten")) phi = ry;
  if (slip("phi less delta")) phi -= params.delta;
  if (slip("phi is penetration, max(0, -phi)")) phi = std::max(0.0, -phi);
  if (slip("x of the corner as phi")) phi = q(0) + rx;
  if (slip("phi = distance of the corner from the origin")) phi = std::hypot(q(0) + rx, height);
  if (slip("phi is left at 0")) phi = 0;
  if (slip("r from the world's origin")) {
    rx += q(0);
    ry += q(1);
  }
  if (slip("r from the origin in x alone")) rx += q(0);
  if (slip("r from the corner to the centre")) {
    rx = -rx;
    ry = -ry;
  }
  if (slip("r_y is -y, straight down to the ground")) ry = -q(1);
  if (slip("r = (0, -y)")) {
    rx = 0;
    ry = -q(1);
  }
  if (slip("r_x and r_y exchanged in J")) std::swap(rx, ry);
  if (slip("r is a unit vector")) {
    const double n = std::hypot(rx, ry);
    rx /= n;
    ry /= n;
  }
  double jt = -ry, jn = rx;
  if (slip("sign of r_y in J_t")) jt = -jt;
  if (slip("sign of r_x in J_n")) jn = -jn;
  if (slip("r_x in J_t, r_y in J_n")) {
    jt = rx;
    jn = ry;
  }
  if (slip("moment arms left out of J")) jt = jn = 0;
  if (slip("moment arm left out of J_t")) jt = 0;
  if (slip("moment arm left out of J_n")) jn = 0;
  if (slip("absolute values of the moment arms")) {
    jt = std::fabs(jt);
    jn = std::fabs(jn);
  }
  Jacobian J;
  J << 1, 0, 0, 1, jt, jn;
  if (slip("J_t = (-1, 0, r_y)")) J.col(0) *= -1;
  if (slip("J_n = (0, -1, -r_x)")) J.col(1) *= -1;
  if (slip("columns exchanged, [J_n J_t]")) J.col(0).swap(J.col(1));
  if (slip("J all negative")) J = -J;
  if (slip("ones of J left out")) {
    J(0, 0) = 0;
    J(1, 1) = 0;
  }
  if (slip("J row by row into a 2x3 map")) {
    const double a[6] = {1, 0, jt, 0, 1, jn};
    J << a[0], a[1], a[2], a[3], a[4], a[5];
  }
  if (slip("J is left at zero")) J.setZero();
  if (slip("ones of J exchanged")) {
    J(0, 0) = 0;
    J(1, 0) = 1;
    J(0, 1) = 1;
    J(1, 1) = 0;
  }
  return {J, phi};
}

struct Rotation {
  double a, b, c, d;
};
Rotation rotation(double theta) {
  double c = std::cos(theta), s = std::sin(theta);
  if (slip("c = 1, s = theta")) {
    c = 1;
    s = theta;
  }
  if (slip("sine and cosine exchanged")) std::swap(c, s);
  Rotation R{c, -s, s, c};
  if (slip("R transposed")) R = {c, s, -s, c};
  if (slip("first row of R (c, s)")) R.b = s;
  if (slip("second row of R (-s, c)")) R.c = -s;
  if (slip("second row of R (s, -c)")) R.d = -c;
  if (slip("both rows of R (c, -s)")) {
    R.c = c;
    R.d = -s;
  }
  if (slip("both rows of R (s, c)")) {
    R.a = s;
    R.b = c;
  }
  if (slip("rows of R exchanged")) R = {s, c, c, -s};
  return R;
}

const std::array<std::array<double, 2>, 4> signs{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

Contact in_body(const Vector3& q, const Parameters& p, double rx, double ry, double h, double bx,
                double by) {
  if (slip("r in the body frame")) {
    rx = bx;
    ry = by;
  }
  return finish(q, p, rx, ry, h);
}

Contact loop(const Vector3& q, const Parameters& given) {
  const Parameters params = with_parameter_slips(given, "l");
  const auto R = rotation(angle(q));
  std::array<int, 4> order{0, 1, 2, 3};
  if (slip("corners in another order, one left out")) order = {2, 1, 0, 0};
  if (slip("corner 2 twice, corner 3 never")) order = {0, 1, 1, 3};
  int from = 0, to = 4;
  if (slip("loop from the second corner")) from = 1;
  if (slip("loop stops before the fourth corner")) to = 3;
  if (slip("upper two corners alone")) to = 2;
  if (slip("lower two corners alone")) from = 2;
  int best = order[from];
  const bool highest = slip("highest corner"), wide = slip("lowest |y|"),
             left = slip("leftmost corner");
  const bool last = slip("last corner below the centre"),
             next = slip("first corner below its neighbour");
  const auto rx = [&](int k) { return params.l / 2 * (R.a * signs[k][0] + R.b * signs[k][1]); };
  const auto ry = [&](int k) { return params.l / 2 * (R.c * signs[k][0] + R.d * signs[k][1]); };
  for (int i = from; i < to; ++i) {
    const int k = order[i];
    if (last) {
      if (ry(k) < 0) best = k;
      continue;
    }
    if (next) {
      if (ry(k) < ry((k + 1) % 4)) {
        best = k;
        break;
      }
      continue;
    }
    if (left) {
      if (rx(k) < rx(best)) best = k;
      continue;
    }
    if (wide) {
      if (std::fabs(q(1) + ry(k)) < std::fabs(q(1) + ry(best))) best = k;
      continue;
    }
    if (highest ? ry(k) > ry(best) : ry(k) < ry(best)) best = k;
  }
  for (int k = 0; k < 4; ++k)
    if (slip("always corner " + std::to_string(k + 1))) best = k;
  int of_J = best;
  for (int k = 0; k < 4; ++k)
    if (slip("J always of corner " + std::to_string(k + 1) + ", phi right")) of_J = k;
  if (slip("J of the corner after the lowest")) of_J = (best + 1) % 4;
  if (slip("contact kept from the last call")) {
    auto& kept = program().kept["corner"];
    const int now = of_J;
    if (kept.size()) of_J = static_cast<int>(kept(0));
    kept = Eigen::MatrixXd::Constant(1, 1, now);
  }
  return in_body(q, params, rx(of_J), ry(of_J), q(1) + ry(best), signs[of_J][0] * params.l / 2,
                 signs[of_J][1] * params.l / 2);
}

Contact written(const Vector3& q, const Parameters& given) {
  const Parameters params = with_parameter_slips(given, "l");
  const double theta = angle(q), h = params.l / 2, c = std::cos(theta), s = std::sin(theta);
  double x[4], y[4];
  for (int k = 0; k < 4; ++k) {
    const std::string n = std::to_string(k + 1);
    double xc = signs[k][0] * c, xs = -signs[k][1] * s, ys = signs[k][0] * s, yc = signs[k][1] * c;
    if (slip("sign of the cosine in x" + n)) xc = -xc;
    if (slip("sign of the sine in x" + n)) xs = -xs;
    if (slip("sign of the sine in y" + n)) ys = -ys;
    if (slip("sign of the cosine in y" + n)) yc = -yc;
    if (slip("cosine forgotten in x" + n)) xc = signs[k][0];
    if (slip("sine forgotten in x" + n)) xs = -signs[k][1];
    if (slip("cosine forgotten in y" + n)) yc = signs[k][1];
    if (slip("sine forgotten in y" + n)) ys = signs[k][0];
    if (slip("sine term left out of y" + n)) ys = 0;
    if (slip("cosine term left out of y" + n)) yc = 0;
    if (slip("cosine twice in y" + n)) ys = signs[k][0] * c;
    if (slip("sine twice in y" + n)) yc = signs[k][1] * s;
    x[k] = h * (xc + xs);
    y[k] = h * (ys + yc);
    if (slip("whole side in corner " + n)) {
      x[k] *= 2;
      y[k] *= 2;
    }
  }
  for (int k = 0; k < 4; ++k) {
    const std::string n = std::to_string(k + 1), before = std::to_string((k + 3) % 4 + 1);
    if (slip("corner " + before + " typed in place of corner " + n)) {
      x[k] = x[(k + 3) % 4];
      y[k] = y[(k + 3) % 4];
    }
  }
  int best = 0;
  for (int k = 1; k < 4; ++k) {
    if (slip("corner " + std::to_string(k + 1) + " not compared")) continue;
    if (y[k] < y[best]) best = k;
  }
  int jx = best, jy = best;
  for (int k = 0; k < 4; ++k) {
    const std::string n = std::to_string(k + 1);
    if (best == k && slip("branch " + n + " takes x of the next corner")) jx = (k + 1) % 4;
    if (best == k && slip("branch " + n + " takes r of the next corner")) jx = jy = (k + 1) % 4;
    if (best == k && slip("branch " + n + " takes r of corner 1")) jx = jy = 0;
  }
  return in_body(q, params, x[jx], y[jy], q(1) + y[best], signs[jx][0] * h, signs[jy][1] * h);
}

Contact matrix(const Vector3& q, const Parameters& given) {
  const Parameters params = with_parameter_slips(given, "l");
  const auto r = rotation(angle(q));
  Eigen::Matrix2d R;
  R << r.a, r.b, r.c, r.d;
  Eigen::Matrix<double, 2, 4> S;
  S << 1, -1, -1, 1, 1, 1, -1, -1;
  if (slip("second row of the corners 1 -1 1 -1")) S.row(1) << 1, -1, 1, -1;
  if (slip("first row of the corners 1 1 -1 -1")) S.row(0) << 1, 1, -1, -1;
  if (slip("first row of the corners all 1")) S.row(0).setOnes();
  if (slip("corners l/2 (1,0), (0,1), (-1,0), (0,-1)")) S << 1, 0, -1, 0, 0, 1, 0, -1;
  S *= params.l / 2;
  Eigen::Matrix<double, 2, 4> r_all = R * S;
  if (slip("R forgotten")) r_all = S;
  if (slip("R applied twice")) r_all = R * R * S;
  Eigen::Index k = 0;
  r_all.row(1).minCoeff(&k);
  if (slip("minimum over x")) r_all.row(0).minCoeff(&k);
  if (slip("maximum over y")) r_all.row(1).maxCoeff(&k);
  double h = q(1) + r_all(1, k);
  if (slip("x added to y of the corner")) h = q(0) + r_all(1, k);
  if (slip("centre turned too")) h = (R * (Eigen::Vector2d(q(0), q(1)) + S.col(k)))(1);
  return in_body(q, params, r_all(0, k), r_all(1, k), h, S(0, k), S(1, k));
}

Contact complex_numbers(const Vector3& q, const Parameters& given) {
  const Parameters params = with_parameter_slips(given, "l");
  using C = std::complex<double>;
  double theta = angle(q);
  double radius = params.l / std::sqrt(2.0), offset = pi / 4;
  if (slip("half diagonal is l")) radius = params.l;
  if (slip("half diagonal is l / 2")) radius = params.l / 2;
  if (slip("half diagonal is l sqrt(2)")) radius = params.l * std::sqrt(2);
  if (slip("half diagonal is l * 0.7")) radius = params.l * 0.7;
  if (slip("45 degrees forgotten")) offset = 0;
  if (slip("45 as radians")) offset = 45;
  if (slip("pi = 3.14")) offset = 3.14 / 4;
  C turn = std::exp(C(0, theta));
  if (slip("conjugate of the turn")) turn = std::conj(turn);
  C best = 1e9, body = 0;
  int count = 4;
  if (slip("loop stops before the fourth corner")) count = 3;
  for (int k = 0; k < count; ++k) {
    double quarter = pi / 2 * k;
    if (slip("corners an eighth of a turn apart")) quarter = pi / 4 * k;
    if (slip("corners half a turn apart")) quarter = pi * k;
    if (slip("corners 1.57 apart")) quarter = 1.57 * k;
    const C s = std::polar(radius, offset + quarter);
    const C r = turn * s;
    if (slip("compares the real parts") ? r.real() < best.real() : r.imag() < best.imag()) {
      best = r;
      body = s;
    }
  }
  if (slip("real and imaginary part exchanged in r")) best = C(best.imag(), best.real());
  return in_body(q, params, best.real(), best.imag(), q(1) + best.imag(), body.real(), body.imag());
}

Contact closed(const Vector3& q, const Parameters& given) {
  const Parameters params = with_parameter_slips(given, "l");
  const double theta = angle(q), h = params.l / 2;
  double c = std::cos(theta), s = std::sin(theta);
  double quarter = pi / 2;
  if (slip("pi = 3.14")) quarter = 1.57;
  double turns = std::floor(theta / quarter);
  if (slip("index rounded towards zero")) turns = std::trunc(theta / quarter);
  if (slip("index rounded to the nearest")) turns = std::round(theta / quarter);
  long k = static_cast<long>(turns);
  if (slip("index modulo 3"))
    k = ((k % 3) + 3) % 3;
  else if (slip("index modulo 4 keeps its sign"))
    k = k % 4 < 0 ? 0 : k % 4;
  else
    k = ((k % 4) + 4) % 4;
  if (slip("corners in the other order")) k = 3 - k;
  if (slip("index a quarter off")) k = (k + 1) % 4;
  if (slip("index half a turn off")) k = (k + 2) % 4;
  if (slip("first quadrant's corner in all quadrants")) k = 0;
  if (slip("first two quadrants alone")) k = k % 2;
  for (int n = 0; n < 4; ++n)
    if (k == n && slip("corner of quadrant " + std::to_string(n + 1) + " wrong")) k = (n + 1) % 4;
  // theta in the first quadrant: corner 3 (-,-) is lowest; each quarter turn the one before it.
  const int corner = static_cast<int>((2 + 4 - k) % 4);
  double rx = h * (signs[corner][0] * c - signs[corner][1] * s);
  double ry = h * (signs[corner][0] * s + signs[corner][1] * c);
  double height = q(1) + ry;
  if (slip("phi = y - l/2 (|c| + |s|), J of another corner")) {
    height = q(1) - h * (std::fabs(c) + std::fabs(s));
  }
  if (slip("r_x = l/2 (|s| - |c|)")) rx = h * (std::fabs(s) - std::fabs(c));
  if (slip("r_x = l/2 (s - c)")) rx = h * (s - c);
  if (slip("r_x with the other sign")) rx = -rx;
  if (slip("phi = y - l/2 (c + s)")) height = q(1) - h * (c + s);
  if (slip("phi = y - l (|c| + |s|)")) height = q(1) - 2 * h * (std::fabs(c) + std::fabs(s));
  if (slip("phi = y - l/2 |c|")) height = q(1) - h * std::fabs(c);
  if (slip("phi = y - half diagonal times |cos theta|"))
    height = q(1) - h * std::sqrt(2) * std::fabs(c);
  return in_body(q, params, rx, ry, height, signs[corner][0] * h, signs[corner][1] * h);
}
}  // namespace

const std::map<std::string, GetContacts>& part1_styles() {
  static const std::map<std::string, GetContacts> styles{{"loop", loop},
                                                         {"written out", written},
                                                         {"matrix", matrix},
                                                         {"complex numbers", complex_numbers},
                                                         {"closed form", closed}};
  return styles;
}
}  // namespace slips
