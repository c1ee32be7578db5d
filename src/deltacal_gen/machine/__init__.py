"""Machines that compute, and by which kernels."""
