"""All commands with their options, for the page that lists them."""

from nonhertz.cli.commands import application

app = application()
