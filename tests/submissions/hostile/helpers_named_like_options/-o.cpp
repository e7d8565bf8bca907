int second_helper = 2;
