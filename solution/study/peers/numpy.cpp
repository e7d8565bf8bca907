#include "numpy.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <sstream>
#include <stdexcept>

#include "engine.hpp"

namespace bounce::study {
namespace {

constexpr double kLeastDt = 1e-3, kCloseDt = 1e-2;  // s

struct Pipe {
  std::array<int, 2> ends{};
  Pipe() {
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe to numpy");
  }
};

// In the child. A second thread would be counted as CPU time, and gains nothing for 4x4 matrices.
[[noreturn]] void become_python(const Pipe& in, const Pipe& out) {
  dup2(in.ends[0], STDIN_FILENO);
  dup2(out.ends[1], STDOUT_FILENO);
  for (const Pipe* pipe : {&in, &out})
    for (const int end : pipe->ends) close(end);
  for (const char* const name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"})
    setenv(name, "1", 1);
  execl("/usr/bin/python3", "python3", BOUNCE_NUMPY, nullptr);
  _exit(127);
}

std::string question(const Scene& scene, const Grid& grid, long repeats) {
  const Parameters& p = scene.params;
  std::ostringstream text;
  text.precision(17);
  text << p.l << " " << p.m << " " << p.mu << " " << p.epsilon << " " << p.delta << " " << p.g.x()
       << " " << p.g.y() << " " << p.g.z() << " " << scene.start.q.transpose() << " "
       << scene.start.v.transpose() << " " << grid.dt << " "
       << std::lround(scene.until / grid.samples / grid.dt) << " " << grid.samples << " " << repeats
       << "\n";
  return text.str();
}

}  // namespace

Numpy::Numpy() {
  std::signal(SIGPIPE, SIG_IGN);  // a process that has ended is found by its missing answer
  const Pipe in, out;
  child_ = fork();
  if (child_ < 0) throw std::runtime_error("numpy can't be started");
  if (child_ == 0) become_python(in, out);
  close(in.ends[0]);
  close(out.ends[1]);
  to_ = fdopen(in.ends[1], "w");
  from_ = fdopen(out.ends[0], "r");
  version_ = line();
}

Numpy::~Numpy() {
  std::fclose(to_);  // which ends it
  std::fclose(from_);
  waitpid(child_, nullptr, 0);
}

std::string Numpy::line() {
  std::string text;
  for (int c = std::fgetc(from_); c != EOF && c != '\n'; c = std::fgetc(from_)) text += char(c);
  return text;
}

Numpy::Answer Numpy::run(const Scene& scene, const Grid& grid, long repeats) {
  std::fputs(question(scene, grid, repeats).c_str(), to_);
  std::fflush(to_);
  std::istringstream text(line());
  Answer answer{};
  text >> answer.ns;
  for (methods::Motion<double> s{}; text >> s.x >> s.y >> s.theta;) answer.samples.push_back(s);
  if (answer.samples.size() != std::size_t(grid.samples))
    throw std::runtime_error("the assignment in numpy gave no answer for " + scene.name);
  return answer;
}

Peers numpy() {
  const auto process = std::make_shared<Numpy>();
  if (process->version().empty()) return {};
  return {
      {"numpy",
       "numpy",
       process->version(),
       "",
       true,
       {"double", "by nature", "the assignment's p (eq. 10)", "the assignment's V (eq. 9), Lemke",
        "the assignment's scheme with its fixed delta", "velocity first"},
       "",  // that of the assignment's scheme
       nullptr,
       process,
       kLeastDt,
       kCloseDt}};
}

}  // namespace bounce::study
