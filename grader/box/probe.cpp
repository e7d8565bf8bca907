// probe ATTEMPT [ARGUMENT...]: attempts, from inside a box, what the box must not allow.
//
// Exit status 0 and "could: ..." if the attempt succeeded, 3 and "could not: ..." if it was
// refused. If there is a pipe for answers, a success also sends an answer.
#include <fcntl.h>
#include <linux/capability.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "../runner/frame.hpp"

namespace bounce::box {
namespace {

// The words behind the attempt's name; the first one, and that as a number.
struct Given {
  std::vector<std::string> words;
  std::string word = "";
  long number = 0;
};
using Attempt = bool (*)(const Given&);

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

int open(const std::string& path, int flags) { return ::open(path.c_str(), flags, 0644); }

// Makes the system call with this name. Its arguments are numbers, texts, BUFFER or PARENT.
bool make_a_call(const Given& given) {
  alignas(4096) static char buffer[1 << 16];
  long arguments[6] = {};
  for (std::size_t i = 1; i < given.words.size(); ++i) {
    const char* word = given.words[i].c_str();
    char* end = nullptr;
    arguments[i - 1] = std::strtol(word, &end, 10);
    if (end != word && *end == '\0') continue;
    arguments[i - 1] = reinterpret_cast<long>(given.words[i] == "BUFFER" ? buffer : word);
    if (given.words[i] == "PARENT") arguments[i - 1] = ::getppid();
  }
  const int call = seccomp_syscall_resolve_name(given.word.c_str());
  if (call == __NR_SCMP_ERROR) throw std::runtime_error("no such call: " + given.word);
  const auto& [a, b, c, d, e, f] = arguments;
  return ::syscall(call, a, b, c, d, e, f) >= 0;
}

bool can_read(const Given& given) {
  const int fd = open(given.word, O_RDONLY);
  char byte = 0;
  return fd >= 0 && ::read(fd, &byte, 1) >= 0;
}

// Whether execve looks for the file: how it fails then tells whether there is one.
bool look_by_execve(const Given& given) {
  char* const none[] = {nullptr};
  const char* const path = given.word.c_str();
  if (::execve(path, none, none) != 0 && errno != ENOSYS) return true;
  return ::syscall(SYS_execveat, AT_FDCWD, path, none, none, 0) != 0 && errno != ENOSYS;
}

// Writes more than N MB to one file in the temporary folder.
bool fill(const Given& given) {
  ::signal(SIGXFSZ, SIG_IGN);
  const char* folder = std::getenv("TMPDIR");
  const int fd = open(std::string(folder ? folder : "/tmp") + "/fill", O_WRONLY | O_CREAT);
  const std::string megabyte(1 << 20, 'x');
  for (long left = given.number + 1; left > 0; --left) {
    if (::write(fd, megabyte.data(), megabyte.size()) != ssize_t{1 << 20}) return false;
  }
  return ::lseek(fd, 0, SEEK_CUR) > 0;  // not so in /dev/null
}

// Makes a file in the current folder. A box may say so without doing it.
bool make_a_file(const Given& given) {
  const char* name = given.word.c_str();
  return open(name, O_WRONLY | O_CREAT) >= 0 && ::access(name, F_OK) == 0 && ::unlink(name) == 0;
}

// Starts N processes at once.
bool start_processes(const Given& given) {
  const pid_t self = ::getpid();
  for (long left = given.number; left > 0; --left) {
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

// Starts N threads at once, whose stacks together are within what a program may use.
bool start_threads(const Given& given) {
  pthread_attr_t small;
  ::pthread_attr_init(&small);
  ::pthread_attr_setstacksize(&small, 1 << 18);
  for (long left = given.number; left > 0; --left) {
    pthread_t thread;
    const auto wait = [](void*) -> void* { return ::pause(), nullptr; };
    if (::pthread_create(&thread, &small, wait, nullptr) != 0) return false;
  }
  return true;
}

// Uses N MB, long enough to be noticed from outside.
bool allocate(const Given& given) {
  const std::size_t size = static_cast<std::size_t>(given.number) << 20;
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_ANONYMOUS | MAP_PRIVATE, -1, 0);
  if (memory == MAP_FAILED) return false;
  for (std::size_t at = 0; at < size; at += 4096) static_cast<volatile char*>(memory)[at] = 1;
  const timespec half_a_second{0, 500'000'000};
  ::nanosleep(&half_a_second, nullptr);
  return true;
}

// Uses N MB after the first thread has ended.
bool allocate_late(const Given& given) {
  std::thread([given] { std::exit(report("allocate-late", allocate(given))); }).detach();
  ::syscall(SYS_exit, 0);
  return false;
}

// Uses N seconds of CPU time.
bool spin(const Given& given) {
  while (::clock() < static_cast<clock_t>(given.number * CLOCKS_PER_SEC)) {
  }
  return true;
}

// Prints N MB.
bool flood(const Given& given) {
  const std::string line(1 << 20, 'x');
  for (long left = given.number; left > 0; --left) {
    if (::write(STDOUT_FILENO, line.data(), line.size()) <= 0) return false;
  }
  return true;
}

// Leaves a process behind, in its own session. Whether it outlives the box is checked from outside.
bool leave_a_daemon(const Given&) {
  const pid_t child = ::fork();
  if (child < 0) return false;
  if (child > 0) return ::waitpid(child, nullptr, 0) == child;
  ::setsid();
  if (::fork() == 0) {
    ::close_range(0, ~0U, 0);
    ::sleep(60);
  }
  ::_exit(0);
}

// Whether this file in the /proc folder of any other process can be opened, and holds the other two
// words joined, if they are given.
bool open_files_of_others(const Given& given) {
  const bool has_canary = given.words.size() > 2;
  for (int pid = 1; pid < 40'000; ++pid) {  // /proc may not be listable
    std::ifstream in("/proc/" + std::to_string(pid) + "/" + given.word, std::ios::binary);
    if (pid == ::getpid() || !in) continue;
    if (!has_canary) return true;
    const std::string text(std::istreambuf_iterator<char>(in), {});
    if (text.find(given.words[1] + given.words[2]) != std::string::npos) return true;
  }
  return false;
}

// Tries every descriptor from N on.
bool use_inherited_descriptors(const Given& given) {
  for (int fd = static_cast<int>(given.number); fd < 1024; ++fd) {
    if (::lseek(fd, 0, SEEK_CUR) >= 0 || errno != EBADF) return true;
  }
  return false;
}

bool have_privileges(const Given&) {
  __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct held[2] = {};
  const bool any = ::syscall(SYS_capget, &header, held) == 0 &&
                   (held[0].effective | held[0].permitted | held[1].effective) != 0;
  return any || ::syscall(SYS_geteuid) == 0 || ::setuid(0) == 0;
}

const std::map<std::string, Attempt> kAttempts = {
    {"nothing", [](const Given&) { return true; }},
    {"call", make_a_call},
    {"read", can_read},
    {"write",
     [](const Given& given) { return ::write(open(given.word, O_WRONLY | O_CREAT), "x", 1) == 1; }},
    {"look-by-execve", look_by_execve},
    {"fill", fill},
    {"file", make_a_file},
    {"processes", start_processes},
    {"threads", start_threads},
    {"allocate", allocate},
    {"allocate-late", allocate_late},
    {"spin", spin},
    {"flood", flood},
    {"daemon", leave_a_daemon},
    {"environment", [](const Given& given) { return std::getenv(given.word.c_str()) != nullptr; }},
    {"others", open_files_of_others},
    {"descriptors", use_inherited_descriptors},
    {"privileges", have_privileges},
};

}  // namespace
}  // namespace bounce::box

int main(int argc, char** argv) try {
  bounce::box::Given given{{argv + 2, argv + argc}};
  if (argc > 2) given.word = argv[2];
  given.number = std::atol(given.word.c_str());
  return bounce::box::report(argv[1], bounce::box::kAttempts.at(argv[1])(given));
} catch (const std::exception& e) {
  std::cerr << "probe: " << e.what() << "\n";
  return 125;
}
