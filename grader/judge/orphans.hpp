// Processes that outlive the one that started them. A box ends with its first process; but one that
// is ended while it is still being set up can leave what it has started behind.
#pragma once

#include <sys/types.h>

#include <set>

namespace bounce::judge {

// From here on, the orphans of this process's descendants become its own children.
void adopt_orphans();

// Ends and waits for every child of this process but `started`.
void end_orphans(const std::set<pid_t>& started);

}  // namespace bounce::judge
