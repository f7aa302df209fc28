"""The course: lessons that are run, read as pages and opened as notebooks."""
