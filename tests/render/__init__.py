"""Contexts, keys, GLSL and batches."""
