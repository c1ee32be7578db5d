"""Planar parallelogram, simplified: one virtual rod: tables and kernels."""
