// probe ATTEMPT [ARGUMENT...]: attempts, from inside a box, what the box must not allow.
//
// Exit status 0 and "could: ..." if the attempt succeeded, 3 and "could not: ..." if it was
// refused. If there is a pipe for answers, a success also sends an answer.
#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysinfo.h>
#include <sys/uio.h>
#include <sys/vfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "../runner/frame.hpp"

namespace bounce::box {
namespace {

using Arguments = std::vector<std::string>;
using Attempt = bool (*)(const Arguments&);

bool nothing(const Arguments&) { return true; }

bool read_file(const Arguments& words) {
  const int fd = ::open(words.at(0).c_str(), O_RDONLY);
  char byte = 0;
  return fd >= 0 && ::read(fd, &byte, 1) >= 0;
}

// Whether execve looks for the file: how it fails then tells whether there is one.
bool look_by_execve(const Arguments& words) {
  char* const none[] = {nullptr};
  const char* const path = words.at(0).c_str();
  if (::execve(path, none, none) != 0 && errno != ENOSYS) return true;
  return ::syscall(SYS_execveat, AT_FDCWD, path, none, none, 0) != 0 && errno != ENOSYS;
}

// Whether a descriptor's pipe can be opened again, to read what is written to it.
bool open_again(const Arguments& words) {
  return ::open(("/proc/self/fd/" + words.at(0)).c_str(), O_RDONLY | O_NONBLOCK) >= 0;
}

bool write_file(const Arguments& words) {
  const int fd = ::open(words.at(0).c_str(), O_WRONLY | O_CREAT, 0644);
  return fd >= 0 && ::write(fd, "x", 1) == 1;
}

// Writes more than N MB to one file in the temporary folder.
bool fill(const Arguments& words) {
  ::signal(SIGXFSZ, SIG_IGN);
  const char* folder = std::getenv("TMPDIR");
  const std::string name = std::string(folder ? folder : "/tmp") + "/fill";
  const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT, 0644);
  const std::string megabyte(1 << 20, 'x');
  for (int left = std::stoi(words.at(0)) + 1; left > 0; --left) {
    if (::write(fd, megabyte.data(), megabyte.size()) != ssize_t{1 << 20}) return false;
  }
  return ::lseek(fd, 0, SEEK_CUR) > 0;  // not so in /dev/null
}

// Makes a file in the current folder. A box may say so without doing it.
bool make_a_file(const Arguments& words) {
  const int fd = ::open(words.at(0).c_str(), O_WRONLY | O_CREAT, 0644);
  return fd >= 0 && ::access(words.at(0).c_str(), F_OK) == 0 && ::unlink(words.at(0).c_str()) == 0;
}

bool see_how_full_a_disk_is(const Arguments&) {
  struct statfs disk = {};
  return ::statfs("/", &disk) == 0 || ::fstatfs(STDIN_FILENO, &disk) == 0;
}

// The number of a pipe grows with every pipe that another program makes.
bool see_the_number_of_a_pipe(const Arguments&) {
  struct stat about = {};
  return ::fstat(STDOUT_FILENO, &about) == 0;
}

bool connect_to(const Arguments& words) {
  const int fd = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(words.at(0))));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return fd >= 0 && ::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
}

// Starts N processes at once.
bool start_processes(const Arguments& words) {
  const pid_t self = ::getpid();
  for (int left = std::stoi(words.at(0)); left > 0; --left) {
    const pid_t child = ::fork();
    if (child < 0) return false;
    if (child == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() == self) ::pause();
      ::_exit(0);
    }
  }
  return true;
}

constexpr std::size_t kPage = 4096;  // bytes

volatile char* mapped(std::size_t size, int flags) {
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_ANONYMOUS | flags, -1, 0);
  return memory == MAP_FAILED ? nullptr : static_cast<volatile char*>(memory);
}

// Long enough to be noticed from outside.
bool keep_it() {
  const timespec half_a_second{0, 500'000'000};
  ::nanosleep(&half_a_second, nullptr);
  return true;
}

// Uses N MB.
bool allocate(const Arguments& words) {
  const std::size_t size = std::stoul(words.at(0)) << 20;
  volatile char* memory = mapped(size, MAP_PRIVATE);
  if (!memory) return false;
  for (std::size_t at = 0; at < size; at += kPage) memory[at] = 1;
  return keep_it();
}

// Gives advice N on a page.
bool give_advice(const Arguments& words) {
  volatile char* page = mapped(kPage, MAP_PRIVATE);
  if (!page) return false;
  page[0] = 1;
  return ::madvise(const_cast<char*>(page), kPage, std::stoi(words.at(0))) == 0;
}

// Uses N MB of shared memory, which stays while one page of it is mapped.
bool allocate_unmapped(const Arguments& words) {
  constexpr std::size_t kPiece = std::size_t{50} << 20;
  for (std::size_t left = std::stoul(words.at(0)) / 50; left > 0; --left) {
    volatile char* memory = mapped(kPiece, MAP_SHARED);
    if (!memory) return false;
    for (std::size_t at = 0; at < kPiece; at += kPage) memory[at] = 1;
    ::munmap(const_cast<char*>(memory) + kPage, kPiece - kPage);
  }
  return keep_it();
}

int report(const std::string& name, bool could);

// Uses N MB after the first thread has ended.
bool allocate_late(const Arguments& words) {
  std::thread([words] { std::exit(report("allocate-late", allocate(words))); }).detach();
  ::syscall(SYS_exit, 0);
  return false;
}

// Uses N seconds of CPU time.
bool spin(const Arguments& words) {
  const auto enough = static_cast<clock_t>(std::stol(words.at(0)) * CLOCKS_PER_SEC);
  while (::clock() < enough) {
  }
  return true;
}

// Prints N MB.
bool flood(const Arguments& words) {
  const std::string line(1 << 20, 'x');
  for (int left = std::stoi(words.at(0)); left > 0; --left) {
    if (::write(STDOUT_FILENO, line.data(), line.size()) <= 0) return false;
  }
  return true;
}

// Leaves a process behind, in its own session. Whether it outlives the box is checked from outside.
bool leave_a_daemon(const Arguments&) {
  const pid_t child = ::fork();
  if (child < 0) return false;
  if (child > 0) return ::waitpid(child, nullptr, 0) == child;
  ::setsid();
  if (::fork() == 0) {
    for (int fd = 0; fd < 64; ++fd) ::close(fd);
    ::sleep(60);
  }
  ::_exit(0);
}

bool see_environment(const Arguments& words) { return std::getenv(words.at(0).c_str()); }

std::string whole(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Process ids to try, because /proc may not be listable.
constexpr int kProcesses = 40'000;

// Whether this file in the /proc folder of any other process contains the two words joined.
bool found_in(const char* file, const Arguments& words) {
  const std::string canary = words.at(0) + words.at(1);
  for (int pid = 1; pid < kProcesses; ++pid) {
    const std::string text = whole("/proc/" + std::to_string(pid) + file);
    if (pid != ::getpid() && text.find(canary) != std::string::npos) return true;
  }
  return false;
}

bool find_in_environments(const Arguments& words) { return found_in("/environ", words); }

bool find_in_command_lines(const Arguments& words) { return found_in("/cmdline", words); }

// Whether any other process's stack can be read, and contains the two words joined.
bool find_in_memories(const Arguments& words) {
  const std::string canary = words.at(0) + words.at(1);
  for (int pid = 1; pid < kProcesses; ++pid) {
    const std::string folder = "/proc/" + std::to_string(pid);
    std::ifstream maps(folder + "/maps"), memory(folder + "/mem", std::ios::binary);
    for (std::string line; pid != ::getpid() && std::getline(maps, line);) {
      if (line.find("[stack]") == std::string::npos) continue;
      const auto begin = std::stoull(line, nullptr, 16);
      const auto end = std::stoull(line.substr(line.find('-') + 1), nullptr, 16);
      std::string stack(end - begin, '\0');
      memory.seekg(static_cast<std::streamoff>(begin));
      memory.read(stack.data(), static_cast<std::streamsize>(stack.size()));
      if (stack.find(canary) != std::string::npos) return true;
    }
  }
  return false;
}

// Tries all ways to reach the box's first process; without a box, the parent.
bool reach_the_first_process(const Arguments&) {
  const pid_t first = ::getppid() > 1 ? ::getppid() : 1;
  const std::string folder = "/proc/" + std::to_string(first);
  for (const char* file : {"/mem", "/environ", "/syscall", "/maps", "/fd/0"}) {
    const int fd = ::open((folder + file).c_str(), O_RDONLY);
    char byte = 0;
    if (fd >= 0 && (std::strcmp(file, "/mem") == 0 || ::read(fd, &byte, 1) >= 0)) return true;
  }
  iovec own{&errno, 1}, theirs{&errno, 1};
  return ::process_vm_readv(first, &own, 1, &theirs, 1, 0) == 1 ||
         ::ptrace(PTRACE_SEIZE, first, nullptr, nullptr) == 0;
}

// Tries every descriptor from N on.
bool use_inherited_descriptors(const Arguments& words) {
  for (int fd = std::stoi(words.at(0)); fd < 1024; ++fd) {
    if (::lseek(fd, 0, SEEK_CUR) >= 0 || errno != EBADF) return true;
  }
  return false;
}

bool signal_to(const Arguments& words) { return ::kill(std::stoi(words.at(0)), 0) == 0; }

// The clocks of a process tell that it is there, and how long it has worked.
bool read_the_clock_of(const Arguments& words) {
  timespec time = {};
  const auto clock = static_cast<long>(~std::stoul(words.at(0)) << 3 | 2);
  return ::syscall(SYS_clock_gettime, clock, &time) == 0;
}

// These tell that a process is there, too, and the last how many of all users are.
bool read_the_cpus_of(const Arguments& words) {
  cpu_set_t cpus;
  return ::sched_getaffinity(std::stoi(words.at(0)), sizeof cpus, &cpus) == 0;
}

bool read_the_limits_of(const Arguments& words) {
  rlimit limits = {};
  return ::prlimit(std::stoi(words.at(0)), RLIMIT_NOFILE, nullptr, &limits) == 0;
}

bool set_a_limit(const Arguments&) {
  rlimit limits = {};
  ::getrlimit(RLIMIT_NOFILE, &limits);
  return ::setrlimit(RLIMIT_NOFILE, &limits) == 0;
}

bool count_processes(const Arguments&) {
  struct sysinfo about = {};
  return ::sysinfo(&about) == 0 && about.procs > 0;
}

bool trace(const Arguments& words) {
  return ::ptrace(PTRACE_SEIZE, std::stoi(words.at(0)), nullptr, nullptr) == 0;
}

bool have_privileges(const Arguments&) {
  __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct held[2] = {};
  const bool any = ::syscall(SYS_capget, &header, held) == 0 &&
                   (held[0].effective | held[0].permitted | held[1].effective) != 0;
  return any || ::syscall(SYS_geteuid) == 0 || ::setuid(0) == 0;
}

bool make_a_namespace(const Arguments&) { return ::unshare(CLONE_NEWUSER) == 0; }

const std::map<std::string, Attempt> kAttempts = {
    {"nothing", nothing},
    {"read", read_file},
    {"look-by-execve", look_by_execve},
    {"open-again", open_again},
    {"write", write_file},
    {"fill", fill},
    {"file", make_a_file},
    {"disk", see_how_full_a_disk_is},
    {"pipe", see_the_number_of_a_pipe},
    {"connect", connect_to},
    {"processes", start_processes},
    {"allocate", allocate},
    {"allocate-unmapped", allocate_unmapped},
    {"allocate-late", allocate_late},
    {"advice", give_advice},
    {"spin", spin},
    {"flood", flood},
    {"daemon", leave_a_daemon},
    {"environment", see_environment},
    {"environments", find_in_environments},
    {"command-lines", find_in_command_lines},
    {"memories", find_in_memories},
    {"first-process", reach_the_first_process},
    {"descriptors", use_inherited_descriptors},
    {"signal", signal_to},
    {"clock", read_the_clock_of},
    {"cpus", read_the_cpus_of},
    {"limits", read_the_limits_of},
    {"set-limit", set_a_limit},
    {"count", count_processes},
    {"trace", trace},
    {"privileges", have_privileges},
    {"namespace", make_a_namespace},
};

int report(const std::string& name, bool could) {
  if (!could) {
    std::cout << "could not: " << std::strerror(errno) << "\n";
    return 3;
  }
  std::cout << "could: " << name << "\n" << std::flush;
  frames::Frame answer;
  [[maybe_unused]] const auto written = ::write(frames::kAnswers, &answer, sizeof answer);
  return 0;
}

}  // namespace
}  // namespace bounce::box

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto attempt = bounce::box::kAttempts.at(words.at(0));
  return bounce::box::report(words[0], attempt({words.begin() + 1, words.end()}));
} catch (const std::exception& e) {
  std::cerr << "probe: " << e.what() << "\n";
  return 125;
}
