"""Random calls of GL, GLU and GLUT, sensible and absurd: ``python -m tests.fuzz --calls 1000000 --seed 0``."""
