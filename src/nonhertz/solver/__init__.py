"""The entry points: a contact and what is prescribed in, a solution out; or thousands of them in one call."""
