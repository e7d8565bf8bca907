// bounce_study simulate: the motion of a scene within a tolerance, and what it needs, as JSON.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

namespace bounce::study {

// Writes times (s), q and v (m, rad, m/s, rad/s; one list of 3 for each time), method, bound (m),
// horizon (s), the CPU seconds that it took, and models and methods of advice.hpp. Throws
// std::invalid_argument for a scene or a tolerance (m) that can't be read, exact::Refusal for what
// can't be had.
void simulate(const std::filesystem::path& scene, const std::string& tolerance, std::ostream& out);

}  // namespace bounce::study
