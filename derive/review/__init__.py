"""What reviewers see: the one wing that knows both sides, the derivation and the runtime that uses its kernels."""
