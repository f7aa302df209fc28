"""Snapshot tests: what the rule sees, what the plugin does in whole runs."""
