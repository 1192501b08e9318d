"""Command line of slidewave: prepares cases, starts the two programs, reports. SI units throughout."""

__version__ = "0.1.0"
