"""Results as rows and sentences for people to read: on the terminal, in reports and on the page."""
