"""What comes from outside, and how it is held to conditions: numbers and names, files on disk."""
