"""Python starts runs: results, stops, the program's messages as exceptions, the worked example. usage: runs.py SOURCE_DIR TANKTREAD"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

source, program = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1))
os.environ["PATH"] = f"{program.parent}:{os.environ['PATH']}"
os.environ["PYTHONPATH"] = str(source / "python")
sys.path.insert(0, str(source / "python"))
import tanktread  # noqa: E402

QUICK = {"numerics.dx": "1 um", "time.end": "1 ms"}


class Runs(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.case = self.folder / "relax.toml"
        tanktread.new(self.case, "relax")

    def test_a_run_gives_its_results(self):
        run = tanktread.run(self.case, self.folder / "run", set=QUICK, threads=1)
        self.assertEqual(run.status["status"], "done")
        self.assertAlmostEqual(run.series["time"][-1], 1e-3, delta=1e-4)
        self.assertEqual(run.frame(-1).nodes.shape[1], 2)
        self.assertTrue(run.checks)
        self.assertEqual(run.frame(0).units["pressure"], "Pa")
        self.assertEqual(run.estimate("lambda_C").unit, "")

    def test_a_network_tells_what_passes_its_sections(self):
        case = self.folder / "fork.toml"
        tanktread.new(case, "fork")
        quick = {"numerics.dx": "1 um", "numerics.fluid_only": True, "time.end": "40 ms", "time.average_from": "30 ms"}
        run = tanktread.run(case, self.folder / "fork", set=quick)
        inlet = run.ports["inlet.flow_rate"][-1]
        self.assertAlmostEqual(run.sections["parent.flow_rate"][-1] / inlet, 1.0, delta=1e-3)
        self.assertAlmostEqual(run.estimate("before.mu_rel").value, 1.0, delta=1e-3)
        share = [run.estimate(f"first.{name}.flow_fraction").value for name in ("above", "below")]
        self.assertAlmostEqual(sum(share), 1.0, delta=1e-12)
        self.assertAlmostEqual(share[1], 0.221, delta=0.01)  # finite elements
        self.assertEqual([section["name"] for section in run.places["sections"]], ["near", "parent", "below", "above"])
        self.assertEqual(set(run.section_profiles["section"]), {0, 1, 2, 3})

    def test_a_run_that_is_stopped_goes_on(self):
        part = tanktread.run(self.case, self.folder / "run", set=QUICK, until="0.5 ms")
        self.assertEqual(part.status["status"], "stopped")
        self.assertEqual(part.directory, self.folder / "run")
        whole = tanktread.run(self.case, self.folder / "run", set=QUICK)
        self.assertEqual(whole.status["status"], "done")

    def test_a_sweep_gives_a_table_and_its_runs(self):
        sweep = tanktread.sweep(self.case, self.folder / "G", set=QUICK, jobs=2,
                                over={"cells.cytoplasm_viscosity": ["1.2 cP", "6 cP"], ("cells.radius", "cells.angle"): [("4 um", "0 deg"), ("5 um", "30 deg")]})
        self.assertEqual([run.ending for run in sweep.runs], ["done"] * 4)
        self.assertEqual(sweep[1].values, {"cells.cytoplasm_viscosity": "1.2 cP", "cells.radius": "5 um", "cells.angle": "30 deg"})
        table = sweep.table
        self.assertEqual((len(table), table.units["cells.radius"]), (4, "m"))
        self.assertEqual(list(table["cells.radius"]), [4e-6, 5e-6, 4e-6, 5e-6])
        self.assertEqual(table["lambda_C"][3], sweep[3].results.estimate("lambda_C").value)
        self.assertEqual(table.to_pandas()["ending"][0], "done")
        self.assertEqual(sweep.failed, [])
        again = tanktread.Sweep(tanktread.sweep(self.folder / "G", self.folder / "G").directory)
        self.assertEqual(len(again), 4)
        with self.assertRaisesRegex(tanktread.BadCase, "did you mean 'radius'"):
            tanktread.sweep(self.case, self.folder / "H", set=QUICK, over={"cells.raduis": ["4 um", "5 um"]})

    def test_faults_are_exceptions_with_the_programs_message(self):
        with self.assertRaisesRegex(tanktread.BadCase, "drive") as told:
            tanktread.run(self.case, self.folder / "run", set={**QUICK, "flow.drive": "pull", "cells.raduis": "4 um"})
        self.assertEqual(told.exception.code, 2)
        self.assertIn("did you mean 'radius'", str(told.exception))
        self.assertIn("pull", str(told.exception))
        self.assertFalse((self.folder / "run").exists())
        with self.assertRaisesRegex(tanktread.ProgramError, "cannot open 'absent.toml'") as told:
            tanktread.run("absent.toml")
        self.assertEqual(told.exception.code, 5)
        tanktread.run(self.case, self.folder / "run", set=QUICK)
        with self.assertRaisesRegex(tanktread.InUse, "viscosity"):
            tanktread.run(self.case, self.folder / "run", set={**QUICK, "plasma.viscosity": "2 cP"})
        with self.assertRaisesRegex(tanktread.ProgramError, "is there already"):
            tanktread.new(self.case)
        with self.assertRaisesRegex(FileNotFoundError, "no-such-program"):
            tanktread.run(self.case, program="no-such-program")

    def test_check_tells_before(self):
        told = tanktread.check(self.case, set=QUICK)
        self.assertTrue(told["ready"])
        self.assertAlmostEqual(told["dx_m"], 1e-6)
        hopeless = tanktread.check(self.case, set={**QUICK, "numerics.dt": "1 ms"})
        self.assertFalse(hopeless["ready"])
        self.assertTrue(hopeless["advice"])
        with self.assertRaises(tanktread.BadCase):
            tanktread.check(self.case, set={"numerics.dx": 1})

    def test_values_are_written_as_the_case_file_has_them(self):
        settings = {"membrane.hardening.apply_to": ["shear", "bending"], "numerics.fluid_only": False, "cells.count": 1}
        run = tanktread.run(self.case, self.folder / "run", set={**QUICK, **settings})
        resolved = (run.directory / "resolved.toml").read_text()
        self.assertRegex(resolved, r'apply_to += \["shear", "bending"\]')
        self.assertRegex(resolved, r"fluid_only += false")

    def test_ctrl_c_saves_the_state(self):
        directory = self.folder / "run"
        script = (f"import tanktread; tanktread.run({str(self.case)!r}, {str(directory)!r}, set={{'numerics.dx': '0.2 um', "
                  f"'time.end': '10 s', 'output.series': '1 ms', 'output.frames': '1 s'}}, threads=1)")
        process = subprocess.Popen([sys.executable, "-c", script], start_new_session=True, stderr=subprocess.PIPE)
        end = time.monotonic() + 60
        while time.monotonic() < end and not (directory / "status.json").exists():
            time.sleep(0.05)
        os.killpg(process.pid, signal.SIGINT)
        told = process.communicate(timeout=60)[1].decode()
        self.assertIn("KeyboardInterrupt", told)
        status = tanktread.Results(directory).status
        self.assertEqual(status["status"], "stopped")
        self.assertEqual(status["checkpoint_step"], status["step"])

    def test_the_example_draws_its_two_figures(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError as absent:
            self.skipTest(str(absent))
        subprocess.run([sys.executable, source / "python/example.py", self.folder / "out", "numerics.dx=1 um", "time.end=4 ms",
                        "time.average_from=auto"], check=True, stdout=subprocess.DEVNULL)
        for figure in ("deformation.png", "cells.png"):
            self.assertGreater((self.folder / "out" / figure).stat().st_size, 10000)

    def test_cells_across_an_end_are_drawn_on_both_sides(self):
        try:
            import matplotlib
        except ImportError as absent:
            self.skipTest(str(absent))
        matplotlib.use("Agg")
        run = tanktread.run(self.case, self.folder / "run", set=QUICK)
        frame = run.frame(0)
        self.assertEqual(len(tanktread.draw_cells(frame).patches), 1)
        matplotlib.pyplot.clf()
        frame.nodes[:, 0] += 0.5 * frame.box[0]  # it was in the middle
        self.assertEqual(len(tanktread.draw_cells(frame).patches), 2)

    def test_the_package_has_the_version_of_the_program(self):
        stated = re.search(r'^version = "(.*)"', (source / "python/pyproject.toml").read_text(), re.MULTILINE)[1]
        told = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(told.split()[1], stated)


unittest.main()
