# SPDX-License-Identifier: BSD-3-Clause
"""The report's words, and the papers' tables that benchmarks print beside their own figures."""

import subprocess
import unittest
from pathlib import Path

import hints
import multiresolution
import proxy_pass

HERE = Path(__file__).resolve().parent


def report(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(HERE / "report"), *words], capture_output=True, text=True, check=False)


class Report(unittest.TestCase):
    def test_help_has_every_option(self) -> None:
        done = report("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for option in ("--environment", "--quick", "--only"):
            self.assertIn(f"\n{option} ", done.stdout)

    def test_a_page_that_is_not_there(self) -> None:
        for words in (("--only",), ("--only", "nothing"), ("--quick", "--only", "nothing")):
            done = report(*words)
            self.assertEqual(done.returncode, 2, words)
            self.assertIn("--only takes all, sky, spheres, area, hints, convergence or benchmarks", done.stderr)


class Published(unittest.TestCase):
    def test_hints_table_2(self) -> None:
        """The paper prints these sums."""
        totals = {
            "Containers": (5.62, 11.12), "Cellar": (5.10, 11.36), "Cargo bay": (7.83, 15.87),
            "Sibenik": (5.34, 9.87), "Sponza": (7.01, 12.95), "Cornell box": (5.66, 10.05),
        }  # fmt: skip
        self.assertEqual(list(totals), list(hints.PUBLISHED))
        for name, (two, three) in totals.items():
            self.assertAlmostEqual(sum(hints.PUBLISHED[name].order_2), two, delta=0.011, msg=name)
            self.assertAlmostEqual(sum(hints.PUBLISHED[name].order_3), three, delta=0.011, msg=name)

    def test_multiresolution_table_1(self) -> None:
        for paper in multiresolution.PUBLISHED.values():
            self.assertEqual(list(paper), list(multiresolution.STEPS))

    def test_proxies_rates(self) -> None:
        for rates in (proxy_pass.PAPER_RECEIVERS, proxy_pass.PAPER_BLEEDING):
            self.assertTrue(next(iter(rates.values()))[1], "others are over the first")


if __name__ == "__main__":
    unittest.main()
