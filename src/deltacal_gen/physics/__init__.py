"""Effects on a machine: state, deformation, columns, simulation."""
