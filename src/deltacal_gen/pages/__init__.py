"""Pages: what people read. Templates and the one stylesheet lie here; the manual is shown and built from here."""
