"""Input from outside and its validation: numbers and names, files on disk."""
