"""The commands as functions: paths or objects in, answers out (see `results`): attributes, and by key the JSON.

A function writes only where it is given an output path, and then all or nothing.
"""
