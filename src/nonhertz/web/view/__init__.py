"""What the page shows for a document: solutions, stresses, measured files and mistakes, as plain numbers and text."""
