// In place of serve.cpp where the library that serves a page isn't installed.
#include <iostream>

#include "../drawing.hpp"

int bounce::serve(const std::filesystem::path&) {
  std::cerr
      << "--play needs the library cpp-httplib. Install it: sudo apt install libcpp-httplib-dev "
         "(macOS: brew install cpp-httplib; Windows: vcpkg install cpp-httplib). Then: cmake -S . "
         "-B build && cmake --build build --target bounce\n";
  return 1;
}
