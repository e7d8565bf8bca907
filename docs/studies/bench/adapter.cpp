// An adapter for ./kit study bench: g++ -O2 -std=c++20 adapter.cpp -o my_engine
// Put your own engine in place of Engine.
#include <array>
#include <cmath>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

using nlohmann::json;

// A square as a point: at the ground, its lowest corner's height decides, without friction.
struct Engine {
  explicit Engine(const json& asked)
      : half(asked["l"].get<double>() / 2), epsilon(asked["epsilon"]) {
    for (int i = 0; i < 3; ++i) {
      g[i] = asked["g"][i];
      q[i] = asked["q"][i];
      v[i] = asked["v"][i];
    }
  }
  void step(double dt) {
    for (int i = 0; i < 3; ++i) {
      v[i] += dt * g[i];
      q[i] += dt * v[i];
    }
    const double lowest = q[1] - half * (std::abs(std::sin(q[2])) + std::abs(std::cos(q[2])));
    if (lowest < 0 && v[1] < 0) v[1] *= -epsilon;
  }
  double half, epsilon, g[3], q[3], v[3];
};

int main() {
  const json asked = json::parse(std::cin);
  const double step = asked["step"];
  const std::vector<double> times = asked["times"];
  json poses;
  double spent = 0, rounds = 0;
  for (; spent < 20e6; ++rounds) {  // ns; a short motion is repeated, as clocks are coarse
    Engine engine(asked);
    std::vector<std::array<double, 3>> reached;
    long done = 0;
    const std::clock_t begin = std::clock();  // CPU time
    for (const double end : times) {
      for (; done < std::lround(end / step); ++done) engine.step(step);
      reached.push_back({engine.q[0], engine.q[1], engine.q[2]});
    }
    spent += 1e9 / CLOCKS_PER_SEC * (std::clock() - begin);
    poses = reached;
  }
  std::cout << json{{"q", poses}, {"ns", spent / rounds}} << "\n";
}
