"""Kernels derived from ``derive/`` by "deltacal kernels". Do not edit: change the derivation and run the command."""

MECHANISMS = (
    "delta",
    "diamond",
    "serial",
)
