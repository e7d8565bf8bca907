// Simulates a square with your four parts and writes an animation of it.
#include <exception>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "given/drawing.hpp"

namespace {

constexpr double degree = std::numbers::pi / 180;

// The scene. Change it as you like and run again.
const bounce::Vector3 q_0(0.0, 1.5, 30 * degree);  // x in m, y in m, theta in rad
const bounce::Vector3 v_0(0.0, -0.2, 0.0);         // v_x in m/s, v_y in m/s, omega in rad/s

bounce::Parameters scene_parameters() {
  bounce::Parameters params;  // change any number of it here: params.mu = 0.6, for example
  return params;
}

using Words = std::vector<std::string>;

constexpr const char* kKnown =
    "./build/bounce                               the scene in main.cpp, as animation.html\n"
    "./build/bounce --scene NAME [dt=0.001 ...]   a scene of explore.md, with these numbers\n"
    "./build/bounce --many [NAME] [dt=0.001 ...]  200 throws, almost alike, as many.html\n"
    "./build/bounce --play                        serves a page on which you throw the square\n"
    "./build/bounce --worked                      prints the step that the handout works out\n";

int write(const bounce::Drawing& drawing, const std::filesystem::path& page) {
  bounce::draw(drawing, page);
  std::cout << "The animation is in " << std::filesystem::absolute(page).string()
            << "; open it in a browser.\n";
  return 0;
}

// A page of its own, so that two can be compared: tumble_epsilon=1.html.
std::string page_of(std::string page, const Words& words) {
  for (const std::string& word : words) page += (page.empty() ? "" : "_") + word;
  return page + ".html";
}

int run(const std::string& program, const Words& words) {
  if (words.empty()) {
    const auto params = scene_parameters();
    return write({bounce::simulated({q_0, v_0}, params), params}, "animation.html");
  }
  const std::string option = words[0];
  const Words others(words.begin() + 1, words.end());
  if (option == "--scene") return write(bounce::drawing_of(others), page_of("", others));
  if (option == "--many") return write(bounce::many(others), page_of("many", others));
  if (option == "--play" && words.size() == 1) return bounce::serve(program);
  if (option == "--worked" && words.size() == 1) {
    bounce::worked_example();
    return 0;
  }
  std::cerr << "bounce: " << words.back() << " is not understood; there are:\n" << kKnown;
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argv[0], {argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "No animation was written: " << error.what() << ".\n";
    return 1;
  }
}
