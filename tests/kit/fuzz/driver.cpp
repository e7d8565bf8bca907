// fuzz_NAME --seeds FOLDER  writes the seeds, to be mutated
// fuzz_NAME FOLDER...       takes the inputs in these folders
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "fuzz.hpp"

namespace {

void write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int i = 0;
  for (const std::string& seed : bounce::fuzz::seeds()) {
    std::ofstream(folder / ("seed" + std::to_string(i++)), std::ios::binary) << seed;
  }
}

void take(const std::filesystem::path& input) {
  std::cout << input << std::endl;  // so that the last one is known
  std::ostringstream read;
  read << std::ifstream(input, std::ios::binary).rdbuf();
  const std::string data = read.str();
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(data.data()), data.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && argv[1] == std::string("--seeds")) {
    write_seeds(argv[2]);
    return 0;
  }
  for (int i = 1; i < argc; ++i) {
    for (const auto& input : std::filesystem::directory_iterator(argv[i])) take(input.path());
  }
}
