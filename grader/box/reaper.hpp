// Stays outside of what follows, to wait for it and to count its CPU time; and where there is no
// process namespace that takes everything with it, lets nothing outlive the box.
#pragma once

namespace bounce::box {

// Returns in a child. Here, waits for that child's end, kills what it has left behind, calls
// `afterwards`, and ends as the child did: with its exit status, or 128 + n after signal n.
// When whoever started this process ends, so does the child.
void guard_what_follows(void (*afterwards)());

}  // namespace bounce::box
