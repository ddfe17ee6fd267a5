"""The Python reader sees what a results directory holds. usage: reader.py SOURCE_DIR"""
import pathlib
import subprocess
import sys
import tempfile
import unittest
import warnings

import numpy as np

source = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(source / "python"))
from tanktread import Estimate, Results  # noqa: E402


class Reader(unittest.TestCase):
    def invent(self, *options):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        out = pathlib.Path(scratch.name) / "run"
        subprocess.run([sys.executable, source / "tests/fixtures/invented_results.py", out, *options], check=True)
        return Results(out)

    def test_tables_have_columns_units_and_cells(self):
        run = self.invent()
        self.assertEqual(len(run.series), 60)
        self.assertEqual(run.series.units["mean_velocity"], "m/s")
        self.assertEqual(run.series.units["lambda_C"], "")
        third = run.cells.of_cell(2)
        self.assertEqual(len(third), 60)
        self.assertTrue((third["cell"] == 2).all())
        mean = np.mean([run.cells.of_cell(c)["lambda_C"] for c in range(4)], axis=0)
        np.testing.assert_allclose(run.series["lambda_C"], mean, rtol=1e-8)
        self.assertEqual(len(run.profiles["y"]), run.grid["ny"])
        self.assertIn("window", run.summary["lambda_C"])

    def test_every_entry_of_the_summary_has_a_value_and_a_unit(self):
        run = self.invent()
        for name, entry in run.summary.items():
            self.assertIn("value", entry, name)
            self.assertIn("unit", entry, name)
        self.assertEqual([check["verdict"] for check in run.checks], ["ok"])

    def test_frames_have_outlines_in_the_box_and_fields(self):
        run = self.invent("--frames", "3")
        times = []
        for frame in run.frames():
            times.append(frame.time)
            self.assertEqual(frame.cell_count, 4)
            self.assertEqual(frame.velocity.shape, (run.grid["ny"], run.grid["nx"], 2))
            for cell in range(frame.cell_count):
                outline = frame.outline(cell)
                self.assertTrue(0 <= outline[:, 0].mean() < run.grid["length"])
                shift = (frame.outline(cell, wrapped=False) - outline)[:, 0] / run.grid["length"]
                np.testing.assert_allclose(shift, np.round(shift[0]), atol=1e-9)
            with self.assertRaises(AttributeError):
                frame.temperature
        np.testing.assert_allclose(times, [0, 40e-3, 80e-3])

    def test_frames_are_a_sequence_and_outlive_the_loop(self):
        run = self.invent("--frames", "3")
        frames = run.frames()
        self.assertEqual(len(frames), 3)
        last = list(frames)[-1]
        self.assertEqual(last.nodes.shape, (160, 2))
        for same in (run.frame(2), run.frame(-1), frames[-1], frames[1:][-1]):
            np.testing.assert_array_equal(same.nodes, last.nodes)
            self.assertEqual((same.number, same.step), (2, last.step))
        with self.assertRaises(IndexError):
            run.frame(3)
        self.assertEqual([frame.number for frame in reversed(frames)], [2, 1, 0])

    def test_damaged_frames_are_left_out_with_a_warning(self):
        run = self.invent("--frames", "3")
        path = run.directory / "frames.h5"
        sound = path.read_bytes()
        true = {frame.number: frame for frame in run.frames()}
        for k in range(60):
            damaged = bytearray(sound)
            at = (k * 104729 + 97) % len(sound)
            if k % 3 == 0:
                damaged[at] ^= 1 << k % 8
            elif k % 3 == 1:
                damaged[at:at + 512] = bytes(len(damaged[at:at + 512]))
            else:
                del damaged[at:]
            if damaged == sound:
                continue
            path.write_bytes(damaged)
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                try:
                    frames = list(run.frames())
                except OSError:
                    continue
            self.assertTrue(told or len(frames) == 3)
            for frame in frames:
                np.testing.assert_array_equal(frame.nodes, true[frame.number].nodes)
                np.testing.assert_array_equal(frame.velocity, true[frame.number].velocity)

    def test_estimates_have_their_standard_error_and_unit(self):
        run = self.invent()
        summary = run.summary
        for name, entry in summary.items():
            if entry["value"] is None:
                with self.assertRaisesRegex(KeyError, "no value"):
                    run.estimate(name)
                continue
            estimate = run.estimate(name)
            self.assertEqual(estimate, (entry["value"], entry.get("standard_error"), entry["unit"]))
        self.assertTrue(any("standard_error" in entry for entry in summary.values()))
        self.assertEqual(str(Estimate(2e-3, 1.26e-4, "m/s")), "0.002 ± 0.00013 m/s")

    def test_pandas_and_xarray_get_numbers_and_units(self):
        run = self.invent("--frames", "2")
        try:
            import pandas  # noqa: F401
            import xarray  # noqa: F401
        except ImportError as absent:
            self.skipTest(str(absent))
        table = run.series.to_pandas()
        np.testing.assert_array_equal(table["lambda_C"], run.series["lambda_C"])
        self.assertEqual(table.attrs["units"]["mean_velocity"], "m/s")
        self.assertEqual(run.series.to_xarray()["mean_velocity"].dims, ("time",))
        cells = run.cells.to_xarray()
        self.assertEqual(dict(cells.sizes), {"time": 60, "cell": 4})
        np.testing.assert_array_equal(cells["lambda_C"].sel(cell=2), run.cells.of_cell(2)["lambda_C"])
        self.assertEqual(cells["time"].attrs["units"], "s")
        self.assertEqual(run.profiles.to_xarray()["velocity"].dims, ("y",))
        frame, fields = run.frame(-1), run.frame(-1).to_xarray()
        np.testing.assert_array_equal(fields["velocity"].sel(component="x"), frame.velocity[:, :, 0])
        self.assertAlmostEqual(float(fields["y"][0]), 0.5 * frame.box[1] / run.grid["ny"])

    def test_unfinished_run_gives_what_there_is(self):
        run = self.invent("--stage", "running")
        self.assertEqual(len(run.series), 59)
        self.assertEqual(run.summary, {})
        self.assertEqual(run.checks, [])
        with self.assertRaises(FileNotFoundError):
            run.profiles
        with self.assertRaises(FileNotFoundError):
            Results(run.directory / "absent")


unittest.main()
