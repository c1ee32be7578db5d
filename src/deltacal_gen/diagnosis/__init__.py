"""Which physics was left out, and where."""
