"""Who may ask and how it is answered: socket, routes, what is taken in, processes that compute."""
