"""From kernels to text: one module per target, each with its printer of expressions and its layout of kernels."""
