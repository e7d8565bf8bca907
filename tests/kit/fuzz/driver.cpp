// fuzz_NAME COUNT           tries COUNT mutations of the seeds, the same each time
// fuzz_NAME --seeds FOLDER  writes the seeds, for libFuzzer to begin with
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>

#include "fuzz.hpp"

namespace bounce::fuzz {
namespace {

using Random = std::mt19937_64;

// Gives the same with every standard library, unlike std::uniform_int_distribution.
std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

void change(std::string& data, const std::vector<std::string>& all, Random& random) {
  const std::size_t at = below(random, data.size() + 1),
                    length = std::size_t{1} << below(random, 8);
  const std::string& other = all[below(random, all.size())];
  switch (below(random, 5)) {
    case 0:
      if (at < data.size()) data[at] = static_cast<char>(data[at] ^ (1 << below(random, 8)));
      break;
    case 1:
      for (std::size_t i = at; i < std::min(at + length, data.size()); ++i)
        data[i] = static_cast<char>(random());
      break;
    case 2:
      data.erase(at, length);
      break;
    case 3:
      data.insert(at, data.substr(at, length));
      break;
    default:
      data.replace(at, std::string::npos, other, below(random, other.size() + 1));
  }
}

void take(std::size_t count) {
  const std::vector<std::string> all = seeds();
  Random random(1);
  for (std::size_t i = 0; i < count; ++i) {
    std::string data = all[i % all.size()];
    for (std::size_t changes = i < all.size() ? 0 : below(random, 6); changes > 0; --changes) {
      change(data, all, random);
    }
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(data.data()), data.size());
  }
}

void write_seeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const std::vector<std::string> all = seeds();
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::ofstream(folder / ("seed" + std::to_string(i)), std::ios::binary) << all[i];
  }
}

}  // namespace
}  // namespace bounce::fuzz

int main(int argc, char** argv) try {
  if (argc == 3 && argv[1] == std::string("--seeds")) {
    bounce::fuzz::write_seeds(argv[2]);
  } else if (argc == 2) {
    bounce::fuzz::take(std::stoul(argv[1]));
  } else {
    throw std::runtime_error("usage: fuzz_NAME COUNT | --seeds FOLDER");
  }
} catch (const std::exception& e) {
  std::cerr << e.what() << std::endl;
  return 3;
}
