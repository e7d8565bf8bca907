// Given: what the program bounce does with your four parts.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace bounce {

// What the page of the animation draws.
struct Drawing {
  Trajectory trajectory;  // without v, no forces, energies and true motion are drawn
  Parameters params;
  std::vector<Eigen::Matrix3Xd> many{};  // more trajectories, drawn thin
  std::string title{}, about{};          // "" for the usual ones
};

// What the page's script reads. Throws std::invalid_argument where it can't be drawn.
nlohmann::json data_of(const Drawing& drawing);

// Writes the page, as render does.
void draw(const Drawing& drawing, const std::filesystem::path& page);

// What `simulate` returns. Throws std::runtime_error with a sentence that says where to look if
// that can't be shown.
Trajectory simulated(const State& start, const Parameters& params);

// The scene that the first word names, with numbers that the others change: "tumble", "dt=0.001".
// Throws as `simulated` does, and std::invalid_argument where there is no such scene or number.
Drawing drawing_of(const std::vector<std::string>& words);

// That scene 200 times, from angles within a tenth of a degree; without a name, one in which small
// differences grow fast. Throws as `drawing_of` does.
Drawing many(const std::vector<std::string>& words);

// Takes the step that the handout carries through ("One contact by numbers"), and prints what each
// part returns. Step into it with a debugger.
void worked_example();

// --play: serves a page on which the square can be thrown, on this machine, until this program is
// ended, and returns its exit status. `program` is its own file, beside which stands what calls the
// four parts: when that is built again, the page goes on with the new one.
int serve(const std::filesystem::path& program);

}  // namespace bounce
