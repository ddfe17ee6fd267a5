"""The script of the studies works from plan to page, and its arithmetic is right. usage: studies.py SOURCE_DIR TANKTREAD"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

program = pathlib.Path(sys.argv.pop(2)).resolve()
source = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(source / "studies"))
import common  # noqa: E402


class Arithmetic(unittest.TestCase):
    def test_fit_finds_the_numbers_of_an_exact_curve(self):
        x = np.linspace(1, 40, 15)
        a, b, r2 = common.fit_saturation(x, 0.1771 * (1 - np.exp(-0.0611 * x)))
        np.testing.assert_allclose([a, b, r2], [0.1771, 0.0611, 1.0], rtol=1e-5)

    def test_permutations_tell_apart_what_differs_only(self):
        a = np.linspace(0, 1, 12)
        self.assertLess(common.permutation_p(a, a + 2), 0.001)
        self.assertGreater(common.permutation_p(a, a + 0.01), 0.5)

    def test_sharpest_bend_is_exact_on_a_circle_and_an_ellipse(self):
        angle = np.linspace(0, 2 * np.pi, 400, endpoint=False)
        circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        self.assertAlmostEqual(common.sharpest_bend(3e-6 * circle), 1.0, places=4)
        # Curvature a/b² at the tip, radius √(a b) of the circle of the same area.
        self.assertAlmostEqual(common.sharpest_bend(circle * [2.0, 1.0]), 2.0 * 2.0**0.5, places=2)

    def test_scatter_is_that_over_seeds(self):
        self.assertEqual(common.over_seeds([1.0, 2.0, 3.0]).text(1), "2.0 ± 1.0")


class Script(unittest.TestCase):
    def test_quick_study_makes_every_run_figure_and_claim(self):
        with tempfile.TemporaryDirectory() as scratch:
            line = [sys.executable, source / "studies/paper", "--quick", "--out", scratch, "--tanktread", program]
            made = subprocess.run(line, capture_output=True, text=True)
            self.assertEqual(made.returncode, 0, made.stderr)
            page = (pathlib.Path(scratch) / "paper.html").read_text()
            for folder in (source / "studies").glob("*/analyse.py"):
                self.assertIn(f"id='{folder.parent.name}'", page)
            figures = list(pathlib.Path(scratch).glob("*/*.svg"))
            self.assertEqual(page.count("<img src='data:image/svg+xml;base64,"), len(figures))
            for figure in figures:
                self.assertIn("</svg>", figure.read_text())
            self.assertNotIn("not judged", page)


unittest.main()
