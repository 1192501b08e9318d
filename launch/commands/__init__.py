"""The commands of slidewave, one module each."""
