// Where there is no process namespace that takes everything with it: nothing outlives the box.
#pragma once

namespace bounce::box {

// Returns in a child. Here, waits for that child's end, kills what it has left behind, calls
// `afterwards`, and ends as the child did: with its exit status, or 128 + n after signal n.
// When this process is killed, so is the child.
void guard_what_follows(void (*afterwards)());

}  // namespace bounce::box
