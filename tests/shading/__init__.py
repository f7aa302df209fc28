"""The illumination equation in NumPy."""
