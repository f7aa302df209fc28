"""Built-in scenes and mesh files."""
