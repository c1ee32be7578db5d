"""Commands: what is typed, read, called and written."""
