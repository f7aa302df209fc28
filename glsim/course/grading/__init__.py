"""Grading: many submissions at once, marks as files that learning platforms read, and one page for the teacher."""
