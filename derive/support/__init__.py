"""What kernels call: how they are compiled, kept and called; copied as it stands into ``generated/``."""
