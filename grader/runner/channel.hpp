// The runner's end of the two descriptors. Throws ChannelClosed when the judge is gone.
#pragma once

#include <bounce/types.hpp>

#include "messages.hpp"

namespace bounce::runner {

struct ChannelClosed {};

frames::Frame receive();
void send(const frames::Frame& frame);
void send(const Eigen::Matrix3Xd& columns);

// Asks the judge what an earlier part answers to this frame's arguments. Rethrows what the given
// part threw as std::runtime_error.
frames::Frame call_back(frames::Frame callback);

}  // namespace bounce::runner
