"""The entry points: a contact and its loading in, a solution out; or thousands of them in one call."""
