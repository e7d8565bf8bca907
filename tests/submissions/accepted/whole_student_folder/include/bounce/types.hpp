#error "a submission's own copy of types.hpp was used"
