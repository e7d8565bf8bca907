// Random scenes, the same on every machine.
#pragma once

#include <random>

#include "../exact/scene.hpp"

namespace bounce::study {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * double(engine_() >> 11) * 0x1p-53;
  }
  bool one_of(int n) { return engine_() % std::uint64_t(n) == 0; }

 private:
  std::mt19937_64 engine_;
};

// Uniform in its logarithm; low > 0.
double log_uniform(Random& random, double low, double high);
bool chance(Random& random, double p);
double either_sign(Random& random);

// From 0 to 1, often one of these.
double any_epsilon(Random& random);

// Squares of ordinary size that fall, tumble, slide, rock or rest, for up to 3 s.
Scene random_scene(Random& random);

}  // namespace bounce::study
