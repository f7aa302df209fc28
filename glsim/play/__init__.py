"""Running programs as they are, and shading anew what they draw."""
