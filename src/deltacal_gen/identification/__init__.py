"""What a recording says of a robot's geometry."""
