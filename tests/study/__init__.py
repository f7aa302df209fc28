"""compare, terms, explain, trace, probe."""
