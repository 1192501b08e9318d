"""Entry point of `python3 -m launch`, which the bootstrap script `slidewave` hands over to."""

import sys

from launch.cli import main

sys.exit(main(sys.argv[1:]))
