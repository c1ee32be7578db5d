"""Diamond, two arms in a plane: tables and kernels."""
