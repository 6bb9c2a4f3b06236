"""Files in and out: case files, units, and results on disk."""
