// bounce_measured LAW IMPACTS SETTINGS OUT: the error of a law's velocity after each measured
// impact, with each setting: a float for each, m/s, impact by impact. IMPACTS and SETTINGS are rows
// of doubles, as in the structs below.
//
// The error is the length in the mass metric, sqrt(dv_x^2 + dv_y^2 + r_g^2 domega^2).
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "compliant.hpp"
#include "methods/impact_laws.hpp"

namespace bounce::study {
namespace {

struct Impact {
  double gyration_squared;  // r_g^2, m^2
  Arm<double> corner;       // from the centre of mass to what touches the ground, m
  double v_x, v_y, omega;   // before, m/s and rad/s
  double after_x, after_y, after_omega;
};

struct Setting {
  double mu, epsilon, kappa;  // kappa: of the compliant law alone
};

// v_t = 0 after the impact, whatever friction that takes.
CornerImpulse<double> sticking(const Collision<double>& k) {
  const double u_n = (1 + k.epsilon) * k.v_n, D = k.a * k.c - k.b * k.b;
  const double n = std::max(0.0, (k.b * k.v_t - k.c * u_n) / D);
  return {n, -(k.v_t + k.b * n) / k.c, ContactMode::sticks};
}

CornerImpulse<double> impulse(const std::string& law, Collision<double> k, double kappa) {
  if (law == "sticking") return sticking(k);
  if (law == "compliant") return compliant_impact(k, damping_ratio(k.epsilon), kappa);
  if (law == "poisson") return impact(k, ImpactLaw::poisson);
  if (law == "frictionless") k.mu = 0;
  if (law != "frictionless" && law != "newton") throw std::runtime_error("no law is " + law);
  return impact(k, ImpactLaw::newton);
}

template <class Row>
std::vector<Row> read(const std::string& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const auto bytes = in ? std::size_t(in.tellg()) : 0;
  if (!in || bytes % sizeof(Row) != 0) throw std::runtime_error(file + " can't be read");
  std::vector<Row> rows(bytes / sizeof(Row));
  in.seekg(0);
  in.read(reinterpret_cast<char*>(rows.data()), std::streamsize(bytes));
  return rows;
}

double error(const Impact& hit, const std::string& law, const Setting& with) {
  Motion<double> s{0, 0, 0, hit.v_x, hit.v_y, hit.omega};
  const auto k = one_corner(hit.corner, hit.gyration_squared, 0.0, 0.0, with.mu);
  const double v_n = normal_velocity(s, hit.corner);
  const double v_t = tangential_velocity(s, hit.corner);
  if (v_n < 0) {
    const auto p = impulse(law, {k.a, k.b, k.c, v_n, v_t, with.mu, with.epsilon}, with.kappa);
    apply_impulse(s, hit.corner, p.n, p.t, hit.gyration_squared);
  }
  const double turn = s.omega - hit.after_omega;
  return std::sqrt(std::pow(s.v_x - hit.after_x, 2) + std::pow(s.v_y - hit.after_y, 2) +
                   hit.gyration_squared * turn * turn);
}

void errors(const std::string& law, const std::string& impacts, const std::string& settings,
            const std::string& file) {
  const auto with = read<Setting>(settings);
  std::vector<float> all;
  for (const Impact& hit : read<Impact>(impacts))
    for (const Setting& setting : with) all.push_back(float(error(hit, law, setting)));
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(all.data()), std::streamsize(all.size() * sizeof(float)));
  if (!out.flush()) throw std::runtime_error(file + " can't be written");
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) try {
  if (argc != 5) throw std::runtime_error("usage: bounce_measured LAW IMPACTS SETTINGS OUT");
  bounce::study::errors(argv[1], argv[2], argv[3], argv[4]);
  return 0;
} catch (const std::exception& problem) {
  std::cerr << "bounce_measured: " << problem.what() << '\n';
  return 2;
}
