// What a part that is given answers: the solution, linked into the judge alone.
#pragma once

#include "../runner/frame.hpp"

namespace bounce::judge {

// The reply to a callback. Kind::threw, with the text, where the solution refuses the arguments.
frames::Frame reply_to(const frames::Frame& callback);

}  // namespace bounce::judge
