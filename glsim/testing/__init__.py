"""Snapshot tests: pictures held against approved baselines, as a pytest plugin (plugin.py)."""
