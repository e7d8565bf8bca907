// How many times as long a peer takes as the fastest of ours that is no worse: medians of the
// ratios within a round, with quartiles.
#pragma once

#include "../table.hpp"
#include "turns.hpp"

namespace bounce::study {

Table empty_ratios();

// Adds the rows of a scene. "peer's own": each point of a peer, at its own error. "tolerance": for
// each peer, and for each tolerance that it reaches, its fastest point within. Where none of ours
// is as good, the fields of ours are empty.
void add_ratios(Table& table, const std::string& scene, const std::vector<Point>& points);

}  // namespace bounce::study
