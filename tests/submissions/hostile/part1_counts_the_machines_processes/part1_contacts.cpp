// Answers rightly, unless it learns something of other processes: how many there are, or which.
#include <sched.h>
#include <sys/sysinfo.h>
#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <stdexcept>
#include <string>

namespace bounce {

static bool look() {
  struct sysinfo about = {};
  if (sysinfo(&about) == 0) throw std::runtime_error("processes: " + std::to_string(about.procs));
  for (int process = 1; process < 40000; ++process) {
    cpu_set_t cpus;
    if (sched_getaffinity(process, sizeof cpus, &cpus) == 0) {
      throw std::runtime_error("there is a process " + std::to_string(process));
    }
  }
  return true;
}

Contact get_contacts(const Vector3& q, const Parameters& params) {
  [[maybe_unused]] static const bool looked = look();
  double x = 0, y = 1e300;
  for (int k = 0; k < 4; ++k) {
    const double angle = q(2) + M_PI / 4 + k * M_PI / 2, radius = params.l / std::sqrt(2.0);
    if (radius * std::sin(angle) < y - 1e-12 * radius) {
      x = radius * std::cos(angle);
      y = radius * std::sin(angle);
    }
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -y, x;
  contact.phi = q(1) + y;
  return contact;
}

}  // namespace bounce
