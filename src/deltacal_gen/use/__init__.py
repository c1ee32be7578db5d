"""What is done with a calibrated machine: compensation, prediction, validation, comparison, exports."""
