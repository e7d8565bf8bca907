// Simulates a square with your four parts and writes an animation of it.
//
//   bounce                               the scene below, as animation.html
//   bounce --scene NAME [dt=0.001 ...]   a scene of explore.md, with the numbers that you give
//   bounce --many [NAME] [dt=0.001 ...]  200 throws, almost alike, as many.html
//   bounce --play                        serves a page on which you throw the square yourself
//   bounce --worked                      prints the step that the handout carries through
#include <exception>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "given/drawing.hpp"
#include "given/play/play.hpp"
#ifndef BOUNCE_STUDY
#include "paths.hpp"  // which student/CMakeLists.txt makes
#endif

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

// A scene in which small differences grow fast, for --many.
const Words kLively{"tumble", "epsilon=0.9", "y=1", "dt=0.002", "T=1501"};

int write(const bounce::Drawing& drawing, const std::filesystem::path& page) {
  bounce::draw(drawing, page);
  std::cout << "The animation is in " << std::filesystem::absolute(page).string()
            << "; open it in a browser.\n";
  return 0;
}

// The named scene, with numbers changed as the other words say.
bounce::study::Scene scene_of(const Words& words) {
  std::string names;
  for (bounce::study::Scene& scene : bounce::study::read_scenes(BOUNCE_STUDY)) {
    names += " " + scene.name;
    if (words.empty() || scene.name != words[0]) continue;
    change(scene, {words.begin() + 1, words.end()});
    return scene;
  }
  throw std::invalid_argument("the scenes are:" + names);
}

// Into a page of its own, so that two can be compared: tumble_epsilon=1.html.
int animate_scene(const Words& words) {
  const bounce::study::Scene scene = scene_of(words);
  std::string page;
  for (const std::string& word : words) page += (page.empty() ? "" : "_") + word;
  return write({simulated(scene.start, scene.params), scene.params, {}, scene.title},
               page + ".html");
}

int animate_many(const Words& words) {
  const bool names_scene = !words.empty() && words[0].find('=') == std::string::npos;
  Words all = names_scene ? words : kLively;
  if (!names_scene) all.insert(all.end(), words.begin(), words.end());
  return write(bounce::many(scene_of(all)), "many.html");
}

int run(const std::string& program, const Words& words) {
  const std::string option = words.empty() ? "" : words[0];
  if (words.empty()) {
    const auto params = scene_parameters();
    return write({bounce::simulated({q_0, v_0}, params), params}, "animation.html");
  }
  if (option == "--scene") return animate_scene({words.begin() + 1, words.end()});
  if (option == "--many") return animate_many({words.begin() + 1, words.end()});
  if (option == "--play" && words.size() == 1) return bounce::play::serve(program);
  if (option == "--answer" && words.size() == 2) return bounce::play::answer(words[1]);
  if (option == "--worked" && words.size() == 1) {
    bounce::worked_example();
    return 0;
  }
  std::cerr << "bounce: " << words.back()
            << " is not understood; there are:\n"
               "./build/bounce\n"
               "./build/bounce --scene NAME [dt=0.001 ...]\n"
               "./build/bounce --many [NAME] [dt=0.001 ...]\n"
               "./build/bounce --play\n"
               "./build/bounce --worked\n";
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
