"""Files read and written: robots, recordings, points, printers."""
