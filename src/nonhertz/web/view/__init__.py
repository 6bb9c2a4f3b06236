"""Contents of the page for a document: solutions, stresses, measured files and mistakes, as plain numbers and text."""
