# What clang writes of the prelude, made fit to be optimised and to be linked with often.
# At -O0 it marks all functions as not to be inlined.
/^attributes/s/ noinline / /
# Thousands of groups of one function each: they would take the linker longer to read than all else.
# The functions stay weak, so that a submission may have the same.
/^@/s/, comdat(\(\$[^)]*\))?//
/^define/s/ comdat(\(\$[^)]*\))?//
/^\$.* = comdat any$/d
