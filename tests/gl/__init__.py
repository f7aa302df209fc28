"""The calls of OpenGL, their arguments, errors and names."""
