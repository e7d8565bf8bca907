// In place of the others here where the library that serves a page isn't installed.
#include <iostream>

#include "play.hpp"

namespace bounce::play {

int serve(const std::filesystem::path&) {
  std::cerr
      << "--play needs the library cpp-httplib. Install it: sudo apt install libcpp-httplib-dev "
         "(macOS: brew install cpp-httplib; Windows: vcpkg install cpp-httplib). Then: cmake -S . "
         "-B build && cmake --build build --target bounce\n";
  return 1;
}

int answer(const std::filesystem::path& address) { return serve(address); }

}  // namespace bounce::play
