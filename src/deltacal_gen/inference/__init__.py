"""Inference on linear mixed models: likelihood, sizes of random effects, noise, projection; no robot in it."""
