"""The server: socket, request guard, routes, request parsing, and worker processes."""
