"""Reading and writing files: case files, quantities with units, and results."""
