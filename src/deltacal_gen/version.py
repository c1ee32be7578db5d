"""The version: of the package, of the answers that it writes and of the pages that it makes."""

from __future__ import annotations

__version__ = "0.2.0"
