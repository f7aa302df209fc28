"""Programs that are drawn by glsim and by the driver's own fixed function, and compared."""
