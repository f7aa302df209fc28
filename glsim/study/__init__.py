"""What a student does with a Frame: capture it, compare it under other shading, and more."""
