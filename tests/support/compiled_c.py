"""Exported C, compiled and called."""

from __future__ import annotations

import ctypes
import shutil

import pytest


class At(ctypes.Structure):
    _fields_ = (
        ("temp_C", ctypes.c_double),
        ("payload_kg", ctypes.c_double),
        ("time_s", ctypes.c_double),
        ("approach", ctypes.c_double * 3),
    )


COMPILER = shutil.which("gcc")
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="C is compiled by gcc, which is not installed")
STRICT = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O2", "-fPIC", "-shared"]
JUMPED, LIMITED, NOT_A_NUMBER = 4, 5, 3
