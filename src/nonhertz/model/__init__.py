"""The model: materials, profiles, bodies and contacts, as values that are checked once, when created."""
