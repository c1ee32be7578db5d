"""Measuring plans: poses, studies, singularities."""
