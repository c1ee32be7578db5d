"""Delta, three arms and six rods: tables and kernels."""
