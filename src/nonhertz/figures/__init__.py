"""Figures as values: what is drawn of a result, apart from how it is drawn by matplotlib or in a browser."""
