"""What the page shows of a document: solutions, stresses, measured files and mistakes, as plain numbers and words."""
