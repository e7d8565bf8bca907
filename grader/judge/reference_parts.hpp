// The given parts: the solution, which is linked only into the judge.
#pragma once

#include "../runner/frame.hpp"

namespace bounce::judge {

// The reply to a callback. Kind::threw, with the text, if the solution refuses the arguments.
frames::Frame reply_to(const frames::Frame& callback);

}  // namespace bounce::judge
