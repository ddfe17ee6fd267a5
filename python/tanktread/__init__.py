"""Results of tanktread as arrays in SI units, runs started from Python, cells drawn. Needs numpy and h5py.

    import tanktread
    run = tanktread.run("channel.toml", set={"flow.pseudo_shear_rate": "150 /s"})   # or Results("results/channel")
    run.series["time"], run.series.units["time"]    # numpy array, "s"
    run.cells.of_cell(3)["taylor_inertia"]          # one cell over time
    run.profiles["y"], run.profiles["velocity"]
    run.estimate("lambda_C")                        # value, standard error, unit
    run.checks                                      # what to distrust
    for frame in run.frames():                      # a sequence: len(), [k], [-1]
        frame.time, frame.outline(0), frame.velocity
    tanktread.draw_cells(run.frame(-1))             # with matplotlib
    sweep = tanktread.sweep("channel.toml", "results/seeds", over={"cells.seed": [1, 2, 3]})   # many runs; or Sweep("results/seeds")
    sweep.table["lambda_C"], sweep[0].results       # a row a run; the results of one
    run.series.to_pandas(), run.cells.to_xarray()   # where they are installed
"""
from .draw import draw_cells
from .frames import Frame, Frames
from .program import BadCase, InUse, ProgramError, Unstable, check, new, run
from .results import Estimate, Results
from .sealed_file import SealedFile
from .sweep import Sweep, SweptRun, sweep
from .table import Table

__all__ = ["BadCase", "Estimate", "Frame", "Frames", "InUse", "ProgramError", "Results", "SealedFile", "Sweep", "SweptRun", "Table",
           "Unstable", "check", "draw_cells", "new", "run", "sweep"]
