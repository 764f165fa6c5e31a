"""Folders."""

import sysconfig
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
"""The repository."""
DRIVERS = ROOT / "benches/peers/drivers"
PACKAGES = Path(sysconfig.get_paths()["purelib"])
"""The Python packages."""
