"""Instruments: what they read of a machine, what of themselves is unknown, and one object per kind of measurement."""
