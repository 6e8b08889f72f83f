#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Check that sources include the standard headers whose names they use.

    Testing/Structure/check_headers.py [ROOT]

Another compiler's headers, or another VTK's, include fewer of them by the way. Headers of this
project that a source includes count, those of VTK do not.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

from faults import check

FOLDERS = ("Module", "Testing", "Examples")
ALGORITHMS = (
    "all_of|any_of|binary_search|clamp|copy|copy_if|copy_n|count|count_if|equal|fill|fill_n|find|"
    "find_if|find_if_not|for_each|generate|is_sorted|lower_bound|max|max_element|min|min_element|"
    "minmax|minmax_element|mismatch|none_of|nth_element|partition|remove_if|replace|reverse|rotate|"
    "search|shuffle|sort|stable_sort|transform|unique|upper_bound"
)
NAMES = {
    "algorithm": rf"std::({ALGORITHMS})\(",
    "cstdint": r"std::u?int\d+_t\b",
    "cstdio": r"std::s?n?printf\(",
    "cstdlib": r"std::(getenv|strtod|strtol|abort)\b",
    "cstring": r"std::(mem(cpy|cmp|set)|str(chr|cmp|len|str))\b",
    "fstream": r"std::[io]?fstream\b",
    "iomanip": r"std::set(fill|precision|w)\(",
    "iostream": r"std::(cerr|clog|cout)\b",
    "limits": r"std::numeric_limits\b",
    "numeric": r"std::(accumulate|inner_product|iota)\(",
    "sstream": r"std::[io]?stringstream\b",
}


def find_faults(root: Path) -> list[str]:
    """Return a line for each standard header that a source uses and does not include."""
    paths = [path for name in FOLDERS for path in sorted((root / name).rglob("*"))
             if path.suffix in (".cxx", ".h")]  # fmt: skip
    texts = {path: path.read_text(encoding="utf-8") for path in paths}
    included = {path: re.findall(r'#include\s*["<]([^">]+)[">]', text)
                for path, text in texts.items()}  # fmt: skip
    by_name: dict[str, list[Path]] = {}
    for path in paths:
        by_name.setdefault(path.name, []).append(path)

    def reach(path: Path) -> set[str]:
        found, waiting, seen = set(), [path], {path}
        while waiting:
            for name in included[waiting.pop()]:
                found.add(name)
                for other in by_name.get(Path(name).name, []):
                    if other not in seen:
                        seen.add(other)
                        waiting.append(other)
        return found

    faults = [] if len(paths) > 400 else [f"{root} has {len(paths)} sources only"]
    for path, text in texts.items():
        code = re.sub(r"//.*", "", text)
        known = reach(path)
        faults += [f"{path.relative_to(root)} lacks #include <{header}>"
                   for header, used in NAMES.items()
                   if header not in known and re.search(used, code)]  # fmt: skip
    return faults


if __name__ == "__main__":
    sys.exit(check(find_faults))
