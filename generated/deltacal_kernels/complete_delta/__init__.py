"""Delta, complete geometry of the six rods: tables and kernels."""
