// probe ATTEMPT [ARGUMENT...]: attempts, from inside a box, what the box must not allow.
//
// Exit status 0 and "could: ..." if the attempt succeeded, 3 and "could not: ..." if it was
// refused. If there is a pipe for answers, a success also sends an answer.
#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
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

// The words behind the attempt's name; the first two, and the first as a number.
struct Given {
  std::vector<std::string> words;
  std::string word = "", other = "";
  long number = 0;
};
using Attempt = bool (*)(const Given&);

int open(const std::string& path, int flags) { return ::open(path.c_str(), flags, 0644); }

std::string of_process(pid_t pid, const std::string& file) {
  return "/proc/" + std::to_string(pid) + "/" + file;
}

// Makes the system call with this name. Its arguments are numbers, texts, or BUFFER.
bool make_a_call(const Given& given) {
  alignas(4096) static char buffer[1 << 16];
  long arguments[6] = {};
  for (std::size_t i = 1; i < given.words.size(); ++i) {
    const char* word = given.words[i].c_str();
    char* end = nullptr;
    arguments[i - 1] = std::strtol(word, &end, 10);
    if (end != word && *end == '\0') continue;
    arguments[i - 1] = reinterpret_cast<long>(given.words[i] == "BUFFER" ? buffer : word);
  }
  const int call = seccomp_syscall_resolve_name(given.word.c_str());
  if (call == __NR_SCMP_ERROR) throw std::runtime_error("no such call: " + given.word);
  const auto& [a, b, c, d, e, f] = arguments;
  return ::syscall(call, a, b, c, d, e, f) >= 0;
}

bool can_read(const std::string& path) {
  const int fd = open(path, O_RDONLY);
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

bool connect_to(const Given& given) {
  const int fd = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(given.number));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return fd >= 0 && ::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
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

constexpr std::size_t kPage = 4096;  // bytes

// Memory that is used, or null.
volatile char* used(std::size_t size, int flags) {
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_ANONYMOUS | flags, -1, 0);
  if (memory == MAP_FAILED) return nullptr;
  volatile char* begin = static_cast<volatile char*>(memory);
  for (std::size_t at = 0; at < size; at += kPage) begin[at] = 1;
  return begin;
}

// Long enough to be noticed from outside.
bool keep_it() {
  const timespec half_a_second{0, 500'000'000};
  ::nanosleep(&half_a_second, nullptr);
  return true;
}

// Uses N MB.
bool allocate(const Given& given) {
  return used(static_cast<std::size_t>(given.number) << 20, MAP_PRIVATE) && keep_it();
}

// Uses N MB of shared memory, which stays while one page of it is mapped.
bool allocate_unmapped(const Given& given) {
  constexpr std::size_t kPiece = std::size_t{50} << 20;
  for (long left = given.number / 50; left > 0; --left) {
    volatile char* memory = used(kPiece, MAP_SHARED);
    if (!memory) return false;
    ::munmap(const_cast<char*>(memory) + kPage, kPiece - kPage);
  }
  return keep_it();
}

int report(const std::string& name, bool could);

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

constexpr int kProcesses = 40'000;  // ids to try, because /proc may not be listable

// Whether this file in the /proc folder of any other process contains the two words joined.
bool found_in(const char* file, const Given& given) {
  const std::string canary = given.word + given.other;
  for (int pid = 1; pid < kProcesses; ++pid) {
    std::ifstream in(of_process(pid, file), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    if (pid != ::getpid() && text.find(canary) != std::string::npos) return true;
  }
  return false;
}

// Whether the memory of any other process can be opened.
bool open_memories(const Given&) {
  for (int pid = 1; pid < kProcesses; ++pid) {
    if (pid != ::getpid() && open(of_process(pid, "mem"), O_RDONLY) >= 0) return true;
  }
  return false;
}

// Tries all ways to reach the box's first process; without a box, the parent.
bool reach_the_first_process(const Given&) {
  const pid_t first = ::getppid() > 1 ? ::getppid() : 1;
  if (open(of_process(first, "mem"), O_RDONLY) >= 0) return true;
  for (const char* file : {"environ", "syscall", "maps", "fd/0"}) {
    if (can_read(of_process(first, file))) return true;
  }
  iovec own{&errno, 1}, theirs{&errno, 1};
  return ::process_vm_readv(first, &own, 1, &theirs, 1, 0) == 1 ||
         ::ptrace(PTRACE_SEIZE, first, nullptr, nullptr) == 0;
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
    {"read", [](const Given& given) { return can_read(given.word); }},
    {"write",
     [](const Given& given) { return ::write(open(given.word, O_WRONLY | O_CREAT), "x", 1) == 1; }},
    {"look-by-execve", look_by_execve},
    {"fill", fill},
    {"file", make_a_file},
    {"connect", connect_to},
    {"processes", start_processes},
    {"allocate", allocate},
    {"allocate-unmapped", allocate_unmapped},
    {"allocate-late", allocate_late},
    {"spin", spin},
    {"flood", flood},
    {"daemon", leave_a_daemon},
    {"environment", [](const Given& given) { return std::getenv(given.word.c_str()) != nullptr; }},
    {"environments", [](const Given& given) { return found_in("environ", given); }},
    {"command-lines", [](const Given& given) { return found_in("cmdline", given); }},
    {"memories", open_memories},
    {"first-process", reach_the_first_process},
    {"descriptors", use_inherited_descriptors},
    {"privileges", have_privileges},
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
  bounce::box::Given given{{argv + 2, argv + argc}};
  if (argc > 2) given.word = argv[2];
  if (argc > 3) given.other = argv[3];
  given.number = std::atol(given.word.c_str());
  return bounce::box::report(argv[1], bounce::box::kAttempts.at(argv[1])(given));
} catch (const std::exception& e) {
  std::cerr << "probe: " << e.what() << "\n";
  return 125;
}
