/* Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/inverse.c.jinja; sha256 of both 1ea4295dc3060f49; SymPy 1.14.0. */
