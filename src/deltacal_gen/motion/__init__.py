"""Machines in motion: recordings of samples in time, the torque of their drives, and what explains it."""
