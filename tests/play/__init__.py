"""Unmodified programs, run in a process of their own."""
