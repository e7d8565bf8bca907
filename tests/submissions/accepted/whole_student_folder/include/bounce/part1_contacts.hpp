#error "a submission's own copy of part1_contacts.hpp was used"
