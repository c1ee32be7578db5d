"""From what is said of a machine, an effect or an instrument to functions on graphs of named steps."""
