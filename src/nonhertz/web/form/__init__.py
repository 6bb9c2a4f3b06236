"""From the case file's schema and a document to the form of the page."""
