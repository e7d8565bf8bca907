int first_helper = 1;
