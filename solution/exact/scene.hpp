// A scene of the study: its parameters, its start, and how methods are compared in it.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "../methods/square.hpp"

namespace bounce::study {

// The ladder: each model is the least for some scene. The numbers are the sizes of the LCPs.
enum class ModelLevel {
  asleep,         // nothing at all
  ballistic,      // free flight, in closed form
  one_normal,     // the normal impulse of one corner, 1x1
  one_friction,   // one corner with friction, 4x4
  two_normals,    // the normal impulses of two corners, 2x2
  two_frictions,  // two corners with friction, 8x8
};
inline constexpr int kModelLevels = 6;
const char* name_of(ModelLevel level);

struct Scene {
  std::string name, title;
  Parameters params;
  State start;
  double until;      // compare up to this time, s; errors in the start grow too much afterwards
  ModelLevel least;  // the least model expected to suffice
};
using Scenes = std::vector<Scene>;

// Reads a scene; of one that is not of the study, params, q and v alone, or a scene of a user's
// own, which names what it needs: l, mu, epsilon, g, q, v and until; m, delta, dt and T besides if
// it likes. Throws std::invalid_argument, with a sentence that names the file and the field, if a
// field is missing, unknown, there twice, of the wrong kind, out of range or not finite.
Scene read_scene(const std::filesystem::path& file, bool of_study = true);

// What looks like another unit or another sign than those of the assignment, a sentence each.
std::vector<std::string> doubts(const Scene& scene);

// Every scene of a folder, by name of the file.
Scenes read_scenes(const std::filesystem::path& folder);

// A number with so many digits; 17 give back the same double.
std::string text_of(double x, int digits = 6);

// The distance of two poses, m: of (x, y, l / sqrt 2 theta). Whole turns count.
double distance(const Scene& scene, const Motion<double>& one, const Motion<double>& other);

}  // namespace bounce::study
