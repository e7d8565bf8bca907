// Given: the step that the handout carries through by numbers ("One contact by numbers"), taken by
// your parts. Step into it with a debugger.
#pragma once

namespace bounce {

// Prints what each part returns.
void worked_example();

}  // namespace bounce
