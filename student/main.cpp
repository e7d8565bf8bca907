// Simulates a square with your four parts and writes an animation of it.
//
//   bounce [--compare] [PAGE.html]
//   bounce --scene NAME [dt=0.001 ...]
//   bounce --many [NAME] [dt=0.001 ...]
//   bounce --play
//   bounce --worked
//
// PAGE.html is the file to write (default: animation.html in this folder). With --compare the scene
// is one of the public fixtures, and the right square is shown beside yours. With --scene it is one
// of the scenes of explore.md, with numbers changed as you say. With --many it is thrown 200 times,
// almost alike. With --play it serves a page on which you throw the square yourself. With --worked
// it takes the one step that the handout carries through, and prints what each part returns.
#include <exception>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "given/drawing.hpp"
#include "given/many.hpp"
#include "given/play/play.hpp"
#include "given/simulated.hpp"
#include "given/stored_scene.hpp"
#include "given/study/tables.hpp"
#include "given/worked_example.hpp"
#ifndef BOUNCE_FIXTURES
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

int write(const bounce::Drawing& drawing, const std::filesystem::path& page) {
  bounce::draw(drawing, page);
  std::cout << "The animation is in " << std::filesystem::absolute(page).string()
            << "; open it in a browser.\n";
  return 0;
}

// `right` has no column if nothing is compared.
int animate(const bounce::StoredScene& scene, const std::filesystem::path& page) {
  const auto& [q, v, params, right] = scene;
  return write({bounce::simulated({q, v}, params), params, right}, page);
}

// The named scene, with numbers changed as the other words say.
bounce::study::Scene scene_of(const std::vector<std::string>& words) {
  std::string names;
  for (bounce::study::Scene& scene : bounce::study::read_scenes(BOUNCE_STUDY)) {
    names += " " + scene.name;
    if (words.empty() || scene.name != words[0]) continue;
    change(scene, {words.begin() + 1, words.end()});
    return scene;
  }
  throw std::invalid_argument("the scenes are:" + names);
}

int animate_scene(const std::vector<std::string>& words) {
  const bounce::study::Scene scene = scene_of(words);
  const auto motion = bounce::simulated(scene.start, scene.params);
  return write({motion, scene.params, bounce::Drawing().right, {}, scene.title}, "animation.html");
}

int animate_many(const std::vector<std::string>& words) {
  const bool names_scene = !words.empty() && words[0].find('=') == std::string::npos;
  std::vector<std::string> all = names_scene ? words : bounce::kLively;
  if (!names_scene) all.insert(all.end(), words.begin(), words.end());
  return write(bounce::many(scene_of(all)), "many.html");
}

int run(const std::string& program, std::vector<std::string> words) {
  const std::string option = words.empty() ? "" : words[0];
  if (option == "--worked" && words.size() == 1) {
    bounce::worked_example();
    return 0;
  }
  if (option == "--scene") return animate_scene({words.begin() + 1, words.end()});
  if (option == "--many") return animate_many({words.begin() + 1, words.end()});
  if (option == "--play" && words.size() == 1) return bounce::play::serve(program);
  if (option == "--answer" && words.size() == 2) return bounce::play::answer(words[1]);
  const bool compares = option == "--compare";
  if (compares) words.erase(words.begin());
  const bool names_page = words.size() == 1 && words[0][0] != '-' && words[0].ends_with(".html");
  if (!words.empty() && !names_page) {
    std::cerr << "bounce: " << words.back()
              << " is not understood; there are:\n"
                 "./build/bounce [--compare] [PAGE.html]\n"
                 "./build/bounce --scene NAME [dt=0.001 ...]\n"
                 "./build/bounce --many [NAME] [dt=0.001 ...]\n"
                 "./build/bounce --play\n"
                 "./build/bounce --worked\n";
    return 2;
  }
  const std::string page = words.empty() ? "animation.html" : words[0];
  if (compares) return animate(bounce::stored_scene(BOUNCE_FIXTURES), page);
  return animate({q_0, v_0, scene_parameters(), Eigen::Matrix3Xd(3, 0)}, page);
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
