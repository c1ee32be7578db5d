"""Hexapod of Gough and Stewart, six legs: tables and kernels."""
