"""The state machine: bounds, threads and signals, frames as files."""
