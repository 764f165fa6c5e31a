"""`benches/peers/urdf-to-chain FILE`: prints a URDF file as the text of a chain."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import chain_text, urdf


def main() -> None:
    parser = argparse.ArgumentParser(prog="benches/peers/urdf-to-chain", description=__doc__)
    parser.add_argument("file", type=Path)
    parser.add_argument("--floating", action="store_true", help="the root link moves freely")
    parser.add_argument(
        "--angles-as-written", action="store_true", help="1.57079632679 is not taken as a right angle"
    )
    options = parser.parse_args()
    try:
        robot = urdf.read(options.file, options.floating, not options.angles_as_written)
        print(chain_text.write(robot, options.file.name).text, end="")
    except (OSError, ValueError) as error:
        sys.exit(f"{options.file}: {error}")


if __name__ == "__main__":
    main()
