"""Planar parallelogram, one joint: tables and kernels."""
