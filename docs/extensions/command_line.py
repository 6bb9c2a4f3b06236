"""All commands with their options, for the page that lists them."""

from nonhertz.cli.commands import build_application

app = build_application()
