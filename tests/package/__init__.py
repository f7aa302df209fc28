"""What is shipped, and what the README promises."""
