#line 1 "bwrap: x\ng++: fatal error: Killed signal terminated program cc1plus\nenter: y"
#error
