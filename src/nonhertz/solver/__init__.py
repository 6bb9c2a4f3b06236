"""The verbs: one contact and what is prescribed in, a solution out; thousands of them in one call."""
