"""Kernels derived from ``derive/`` by "deltacal kernels". Do not edit: change the derivation and run the command."""

MECHANISMS = (
    "complete_delta",
    "delta",
    "diamond",
    "hexapod",
    "linear_delta",
    "planar_parallelogram",
    "robotennis",
    "serial",
    "simplified_parallelogram",
)
