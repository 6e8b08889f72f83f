# SPDX-License-Identifier: BSD-3-Clause
"""``python3 -m vtkindirect`` is the command line ``vtk-indirect``."""

import sys

try:
    from vtkindirect import interrupts
    from vtkindirect.cli import main
except ImportError as error:  # such as a package that is missing
    sys.exit(f"vtk-indirect: error: {error}")

interrupts.end_program()
sys.exit(main())
