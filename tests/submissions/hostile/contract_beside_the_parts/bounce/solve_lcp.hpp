#error not the kit's
