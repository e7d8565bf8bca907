// The assignment in numpy, in a process of its own that waits for its turns: so it is timed in the
// same rounds as all others, and on the same core, which a child takes from its parent.
#pragma once

#include <sys/types.h>

#include <cstdio>

#include "../catalog.hpp"

namespace bounce::study {

class Numpy {
 public:
  // Throws std::runtime_error where the process can't be started.
  Numpy();
  Numpy(const Numpy&) = delete;
  Numpy& operator=(const Numpy&) = delete;
  ~Numpy();

  // Empty where Python has no numpy.
  const std::string& version() const { return version_; }

  // The square at kSamples even times up to scene.until. dt must fit, as by fitting_step().
  Samples samples(const Scene& scene, double dt) { return run(scene, dt, 1).samples; }

  // CPU time of so many runs together, ns, as its process counts it.
  double time_of(const Scene& scene, double dt, long repeats) { return run(scene, dt, repeats).ns; }

 private:
  struct Answer {
    double ns;
    Samples samples;
  };
  Answer run(const Scene& scene, double dt, long repeats);
  std::string line();

  pid_t child_ = -1;
  std::FILE *to_ = nullptr, *from_ = nullptr;
  std::string version_;
};

}  // namespace bounce::study
