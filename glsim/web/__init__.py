"""Pages for a browser: offline, one file each, nothing fetched."""
