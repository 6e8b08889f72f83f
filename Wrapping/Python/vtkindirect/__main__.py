# SPDX-License-Identifier: BSD-3-Clause
"""``python3 -m vtkindirect`` is the command line ``vtk-indirect``."""

import sys

from vtkindirect.cli import main

sys.exit(main())
