"""The strip-element method: arrays in, arrays out."""
