// The runner's end of the two pipes to the judge. Throws ChannelClosed when the judge is gone.
#pragma once

#include <bounce/types.hpp>

#include "messages.hpp"

namespace bounce::runner {

struct ChannelClosed {};

frames::Frame receive();
void send(const frames::Frame& frame);
void send(const Eigen::Matrix3Xd& columns);

// Asks the judge for an earlier part's result.
frames::Frame call_back(frames::Frame callback);

}  // namespace bounce::runner
