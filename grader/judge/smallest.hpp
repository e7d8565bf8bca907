// Looks for the simplest case in which a program is wrong: made for this program, in round numbers,
// and none of the hidden ones, so that it can be shown whole.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "../../tests/parts/smallest.hpp"
#include "session.hpp"

namespace bounce::judge {

// Starts the program anew; it has been asked nothing.
using Begin = std::function<std::unique_ptr<Session>()>;

// Simplifies the case in which the check fails, number by number, as long as the program is still
// wrong and correct programs can't differ. A program that is right when it is asked this case first
// keeps something from another one, which is then shown, too: it is looked for in `before`. Empty
// if there is none, or digits of a hidden case are left. If the program ends or hangs
// meanwhile, the simplest so far stands.
std::optional<words::Smallest> smallest(const Begin& begin, const tests::Check& check,
                                        const tests::Case& failed,
                                        const std::vector<tests::Case>& before);

}  // namespace bounce::judge
