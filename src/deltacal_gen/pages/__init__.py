"""Pages and pictures: results in, text out."""
