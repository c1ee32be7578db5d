"""Linear delta, three towers and six rods: tables and kernels."""
