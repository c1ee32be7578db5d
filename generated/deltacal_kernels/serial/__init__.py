"""Open chain of revolute and prismatic joints: tables and kernels."""
