"""The score record, said in the words of other programs. Pure functions of the record."""
