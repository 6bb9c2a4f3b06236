"""From the case file's schema and a document to the form on the page."""
