"""GLU: matrices, quadrics, tessellation, NURBS, mipmaps."""
