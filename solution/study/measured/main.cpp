// Answers what measured/ asks about its impacts and drops. Files are rows of doubles.
//
//     bounce_measured errors LAW IMPACTS SETTINGS OUT        a float for each impact and setting:
//                                                            the error of v after, m/s
//     bounce_measured after LAW IMPACTS SETTINGS OUT         v_x, v_y, omega for each
//     bounce_measured drops LAW WORLD STARTS SETTING SAMPLES OUT   x, y, theta for each sample
//
// The error is the length in the mass metric, sqrt(dv_x^2 + dv_y^2 + r_g^2 domega^2).
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "drops.hpp"

namespace bounce::measured {
namespace {

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

template <class Item>
void write(const std::string& file, const std::vector<Item>& items) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(items.data()),
            std::streamsize(items.size() * sizeof(Item)));
  if (!out.flush()) throw std::runtime_error(file + " can't be written");
}

double error(const Impact& hit, const Velocity& v) {
  const double turn = v.omega - hit.after_omega;
  return std::sqrt(std::pow(v.x - hit.after_x, 2) + std::pow(v.y - hit.after_y, 2) +
                   hit.gyration_squared * turn * turn);
}

void errors(const std::string& law, const std::string& impacts, const std::string& settings,
            const std::string& out) {
  const auto with = read<Setting>(settings);
  const Law after = law_named(law);
  std::vector<float> all;
  for (const Impact& hit : read<Impact>(impacts))
    for (const Setting& setting : with) all.push_back(float(error(hit, after(hit, setting))));
  write(out, all);
}

void after(const std::string& law, const std::string& impacts, const std::string& settings,
           const std::string& out) {
  const auto with = read<Setting>(settings);
  const Law function = law_named(law);
  std::vector<Velocity> all;
  for (const Impact& hit : read<Impact>(impacts))
    for (const Setting& setting : with) all.push_back(function(hit, setting));
  write(out, all);
}

struct Pose {
  double x, y, theta;
};

void drops(const std::string& law, const std::string& world, const std::string& starts,
           const std::string& setting, int samples, const std::string& out) {
  const World where = read<World>(world).at(0);
  const Setting with = read<Setting>(setting).at(0);
  std::vector<Pose> all;
  for (const auto& start : read<methods::Motion<double>>(starts))
    for (const auto& s : drop(where, start, law, with, samples)) all.push_back({s.x, s.y, s.theta});
  write(out, all);
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 5 && words[0] == "errors") {
    errors(words[1], words[2], words[3], words[4]);
  } else if (words.size() == 5 && words[0] == "after") {
    after(words[1], words[2], words[3], words[4]);
  } else if (words.size() == 7 && words[0] == "drops") {
    drops(words[1], words[2], words[3], words[4], std::stoi(words[5]), words[6]);
  } else {
    throw std::runtime_error(
        "usage: errors | after LAW IMPACTS SETTINGS OUT, or "
        "drops LAW WORLD STARTS SETTING SAMPLES OUT");
  }
  return 0;
}

}  // namespace
}  // namespace bounce::measured

int main(int argc, char** argv) {
  try {
    return bounce::measured::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "bounce_measured: " << error.what() << '\n';
    return 2;
  }
}
