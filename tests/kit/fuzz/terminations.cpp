// Fuzzes the readers of a program's last text: what is said of it is one line of bounded length.
#include <csignal>

#include "../../../grader/judge/termination.hpp"
#include "../../../grader/runner/crash.hpp"
#include "../../../grader/words/ending.hpp"
#include "../../../grader/words/sentences.hpp"
#include "fuzz.hpp"

namespace bounce::fuzz {

std::vector<std::string> seeds() {
  const std::string file = "/usr/include/eigen3/Eigen/src/Core/DenseCoeffsBase.h:425: ";
  return {
      "runner: " + file + "Scalar& f(Index): Assertion `index >= 0 && index < size()' failed.\n",
      "/usr/include/c++/12/bits/stl_vector.h:1123: f: Assertion '__n < this->size()' failed.\n",
      "a print\n" + std::string(runner::kStack) + " 0x40a1b2 0x40a1c3\n",
      "terminate called after throwing an instance of '" + std::string(200, '\x9a') +
          "'\n  what():  " + std::string(200, '\x9a') + "\n",
      std::string(200, ':') + "1: Assertion `Assertion `' failed' failed",
  };
}

}  // namespace bounce::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using bounce::judge::in_one_line, bounce::fuzz::is_one_line, bounce::fuzz::require;
  bounce::words::sentences_folder = BOUNCE_SENTENCES;
  const std::string print(reinterpret_cast<const char*>(data), size);
  for (const int status : {SIGABRT, SIGSEGV, SIGXCPU, 3 << 8, (128 + SIGFPE) << 8}) {
    const bounce::judge::Termination termination =
        bounce::judge::termination_of(status, bounce::judge::Limits(), print);
    require(is_one_line(in_one_line(termination)));
    const bounce::words::Ending ending{termination.what, termination.number, termination.text};
    const std::string said = bounce::words::said(ending);
    require(is_one_line(said) && said.size() < 900);
    require(termination.stack.find_first_not_of(" 0123456789abcdefx") == std::string::npos);
  }
  return 0;
}
