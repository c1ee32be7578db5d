"""One weighted nonlinear least-squares problem, and its solvers."""
