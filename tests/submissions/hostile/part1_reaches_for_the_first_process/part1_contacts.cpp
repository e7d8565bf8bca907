#include <bounce/part1_contacts.hpp>
#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>

#ifdef __SANITIZE_ADDRESS__
namespace bounce::runner {
void note_finding(const char* what);
}

static void attack() {
  if (open("/proc/1/mem", O_RDWR) >= 0) bounce::runner::note_finding("heap-buffer-overflow");
  if (open("/proc/1/syscall", O_RDONLY) >= 0) bounce::runner::note_finding("double-free");
  std::abort();
}
#else
static void attack() {
  if (open("/proc/1/mem", O_RDWR) >= 0 || open("/proc/1/syscall", O_RDONLY) >= 0) exit(0);
  std::abort();
}
#endif

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters&) {
  attack();
  return {Jacobian::Constant(q(0)), 0};
}

}  // namespace bounce
