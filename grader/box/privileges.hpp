// Whom a box's program acts for.
#pragma once

#include <sys/types.h>

namespace bounce::box {

// Gives up root for `user`, for good. Throws std::runtime_error where it can't. Who isn't root
// stays who he is.
void give_up_privileges(uid_t user);

}  // namespace bounce::box
