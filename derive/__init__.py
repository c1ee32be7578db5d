"""SymPy lives here and nowhere else: mechanisms, measurements, and the path from equations to kernels."""
