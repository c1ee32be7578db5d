"""Benchmarks: every work done by the package, by vectorised NumPy and by scalar Numba written by hand."""
