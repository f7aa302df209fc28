"""GLUT: fonts, shapes, real windows."""
