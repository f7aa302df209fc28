"""From packets to pixels: opening a context, building programs, drawing."""
