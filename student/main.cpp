// Simulates a square with your four parts and writes an animation of it.
//
//   bounce [--compare] [PAGE.html]
//   bounce --scene NAME [dt=0.001 ...]
//   bounce --worked
//
// PAGE.html is the file to write (default: animation.html in this folder). With --compare the scene
// is one of the public fixtures, and the right square is shown beside yours. With --scene it is one
// of the scenes of explore.md, with numbers changed as you say. With --worked it takes the one step
// that the handout carries through, and prints what each part returns.
#include <bounce/part4_simulate.hpp>
#include <bounce/render.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

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

// Why q can't be shown, as a sentence; empty if it can.
std::string missing(const Eigen::Matrix3Xd& q, const bounce::Parameters& params) {
  if (q.cols() != params.T) {
    const std::string advice = q.cols() == 0 ? "fill in" : "look at the size in";
    return "There is nothing to show yet: simulate returned " + std::to_string(q.cols()) +
           " columns and " + std::to_string(params.T) + " are due, so please " + advice +
           " src/part4_simulate.cpp.";
  }
  for (Eigen::Index t = 0; t < q.cols(); ++t) {
    if (q.col(t).allFinite()) continue;
    return "There is nothing to show yet: column " + std::to_string(t) +
           " of q holds NaN or infinity, so please look at what step makes of the column before.";
  }
  if (q.cols() > 1 && q.rightCols(q.cols() - 1).isZero(0)) {
    return "There is nothing to show yet: step returned only zeros, "
           "so please fill in src/part3_step.cpp.";
  }
  return "";
}

// `right` has no column if nothing is compared.
int animate(const bounce::StoredScene& scene, const std::filesystem::path& page) {
  const auto& [q, v, params, right] = scene;
  const bounce::Trajectory trajectory = bounce::simulate(q, v, params);
  if (const std::string sentence = missing(trajectory.q, params); !sentence.empty()) {
    std::cerr << sentence << '\n';
    return 1;
  }
  bounce::render(trajectory, params, page, right);
  std::cout << "The animation is in " << std::filesystem::absolute(page).string()
            << "; open it in a browser.\n";
  return 0;
}

int animate_scene(const std::vector<std::string>& words) {
  std::string names;
  for (bounce::study::Scene& scene : bounce::study::read_scenes(BOUNCE_STUDY)) {
    names += " " + scene.name;
    if (words.empty() || scene.name != words[0]) continue;
    change(scene, {words.begin() + 1, words.end()});
    return animate({scene.start.q, scene.start.v, scene.params, Eigen::Matrix3Xd(3, 0)},
                   "animation.html");
  }
  std::cerr << "The scenes are:" << names << ".\n";
  return 2;
}

int run(std::vector<std::string> words) {
  const std::string option = words.empty() ? "" : words[0];
  if (option == "--worked" && words.size() == 1) {
    bounce::worked_example();
    return 0;
  }
  if (option == "--scene") return animate_scene({words.begin() + 1, words.end()});
  const bool compares = option == "--compare";
  if (compares) words.erase(words.begin());
  const bool names_page = words.size() == 1 && words[0][0] != '-' && words[0].ends_with(".html");
  if (!words.empty() && !names_page) {
    std::cerr << "bounce: " << words.back()
              << " is not understood; there are:\n"
                 "./build/bounce [--compare] [PAGE.html]\n"
                 "./build/bounce --scene NAME [dt=0.001 ...]\n"
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
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "No animation was written: " << error.what() << ".\n";
    return 1;
  }
}
