// Enters the function of a part that is linked in: BOUNCE_PART is its number. Without it, all are.
#include "linked.hpp"

#ifdef BOUNCE_PART
#define BOUNCE_IS_LINKED(number) (number == BOUNCE_PART)
#else
#define BOUNCE_PART 0
#define BOUNCE_IS_LINKED(number) true
#endif

namespace bounce::tests {

[[maybe_unused]] static const bool is_entered = [] {
#define BOUNCE_ENTER(number, function)              \
  if constexpr (BOUNCE_IS_LINKED(number)) {         \
    linked<& bounce::function> = &bounce::function; \
    linked_parts += #number;                        \
  }
  BOUNCE_FUNCTIONS(BOUNCE_ENTER)
  // A long run is compared with the steps that it takes.
  if constexpr (BOUNCE_PART == 4) linked<& bounce::step> = &bounce::step;
  return true;
}();

}  // namespace bounce::tests
