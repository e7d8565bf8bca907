// Texts, each under its name, as a file holds them. BOUNCE_ACCEPT=1 writes it anew, to be read.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace bounce::tests {

using Texts = std::vector<std::pair<std::string, std::string>>;

inline void expect_texts(const std::string& file, const Texts& texts) {
  const std::string path = BOUNCE_PARTS + ("/" + file);
  std::string all;
  for (const auto& [name, text] : texts) all += "--- " + name + "\n" + text + "\n";
  if (std::getenv("BOUNCE_ACCEPT") != nullptr) std::ofstream(path) << all;
  std::ostringstream expected;
  expected << std::ifstream(path).rdbuf();
  EXPECT_EQ(all, expected.str()) << path;
}

}  // namespace bounce::tests
