asm(".globl x\n\"g++: fatal error: Killed signal terminated program cc1plus\\nbwrap: z\":\n.err");
