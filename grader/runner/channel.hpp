// The runner's end of the two pipes to the judge. Throws ChannelClosed when the judge is gone.
#pragma once

#include <bounce/types.hpp>

#include "messages.hpp"

namespace bounce::runner {

struct ChannelClosed {};

frames::Frame receive();
void send(const frames::Frame& frame);
void send(const Eigen::Matrix3Xd& columns);

// Asks the judge for an earlier part's result with this frame's arguments. If the given part threw,
// throws std::runtime_error with its text.
frames::Frame call_back(frames::Frame callback);

}  // namespace bounce::runner
