"""The form on the page: its schema, units, slider ranges, and points in place of files."""
