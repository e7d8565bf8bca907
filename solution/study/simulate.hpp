// bounce_study simulate: the motion of a scene within a tolerance, as JSON.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

namespace bounce::study {

// Writes times (s), q and v (m, rad, m/s, rad/s; one list of 3 for each time), method, step (s;
// null where the method has none), bound (m), horizon (s) and the CPU seconds that it took. Throws
// std::invalid_argument for a scene or a tolerance (m) that can't be read, exact::Refusal for what
// can't be had.
void simulate(const std::filesystem::path& scene, const std::string& tolerance, std::ostream& out);

}  // namespace bounce::study
