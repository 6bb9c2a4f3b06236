"""What was found, in rows and sentences as people read them: for the terminal, for reports and for the page."""
