"""What instruments report: readings and their derivatives."""
