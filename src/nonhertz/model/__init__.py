"""What is solved: materials, profiles, bodies and contacts, as values that are checked once when made."""
