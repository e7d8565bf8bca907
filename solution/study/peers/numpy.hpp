// The assignment in numpy, in a separate process that waits for its turns. So it is timed in the
// same rounds as all others, and on the same core, which it inherits.
#pragma once

#include <sys/types.h>

#include <cstdio>

#include "../catalog.hpp"

namespace bounce::study {

class Numpy {
 public:
  // Throws std::runtime_error if the process can't be started.
  Numpy();
  Numpy(const Numpy&) = delete;
  Numpy& operator=(const Numpy&) = delete;
  ~Numpy();

  // Empty if Python has no numpy.
  const std::string& version() const { return version_; }

  // The square at the samples of a grid.
  Samples samples(const Scene& scene, const Grid& grid) { return run(scene, grid, 1).samples; }

  // CPU time of so many runs together, ns, as its process counts it.
  double time_of(const Scene& scene, const Grid& grid, long repeats) {
    return run(scene, grid, repeats).ns;
  }

 private:
  struct Answer {
    double ns;
    Samples samples;
  };
  Answer run(const Scene& scene, const Grid& grid, long repeats);
  std::string line();

  pid_t child_ = -1;
  std::FILE *to_ = nullptr, *from_ = nullptr;
  std::string version_;
};

}  // namespace bounce::study
