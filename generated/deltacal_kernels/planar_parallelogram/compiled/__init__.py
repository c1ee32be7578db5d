"""Functions over rows for Numba, of what the package holds for NumPy."""
