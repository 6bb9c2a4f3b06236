"""The report of a whole bearing, made of the same parts as that of a single contact."""
