"""How it is solved: the strip-element method, arrays in and arrays out."""
