// watch run|check COMMAND...: starts a runner (check: one built with sanitizers) under the judge's
// limits, and prints in one line how the wait for an answer ended. It asks nothing; it is for
// testing boxes.
#include <iostream>
#include <string>

#include "runner_process.hpp"

int main(int argc, char** argv) try {
  if (argc < 3) throw std::runtime_error("usage: watch run|check COMMAND...");
  bounce::judge::Limits limits;
  limits.sanitized = std::string(argv[1]) == "check";
  bounce::judge::RunnerProcess runner({argv + 2, argv + argc}, limits);
  try {
    static_cast<void>(runner.receive());
    std::cout << "answered\n";
  } catch (const bounce::judge::RunnerEnded& ended) {
    std::cout << ended.termination.status << ": " << ended.what() << "\n";
  }
  return 0;
} catch (const std::exception& e) {
  std::cerr << "watch: " << e.what() << "\n";
  return 1;
}
