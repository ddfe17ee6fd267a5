"""Conversions in this process, and what is asked of them."""
import importlib.util
import pathlib
import sys
import tempfile
import time

source = pathlib.Path(sys.argv[1]).resolve()
data = source / "tests/data/chips"
missing = [name for name in ("ezdxf", "gdspy", "svgelements", "shapely", "PIL", "contourpy") if importlib.util.find_spec(name) is None]
if missing:
    print(f"skipped: python3 has no {', '.join(missing)} (tools/install test)")
    sys.exit(77)
sys.path.insert(0, str(source / "src/io"))
sys.dont_write_bytecode = True
import warnings  # noqa: E402

warnings.simplefilter("ignore")
import numpy as np  # noqa: E402
from chips.__main__ import convert  # noqa: E402
from chips.drawing import Options, Refused  # noqa: E402

folder = pathlib.Path(tempfile.mkdtemp())


def loops_of(path, **options):
    """Loops [µm] and what was told of them, by label."""
    csv, told = convert(pathlib.Path(path), Options(**options))
    blocks = [block for block in csv.split("\n\n") if block.strip()]
    loops = [np.array([[float(word) for word in line.split(",")] for line in block.splitlines() if not line.startswith("#")])
             for block in blocks]
    return loops, {label: text for label, text in told["found"]} | {"remarks": told["remarks"]}


def refusal(path, **options) -> str:
    try:
        loops, told = loops_of(path, **options)
    except Refused as refused:
        return "\n".join(refused.messages)
    raise AssertionError(f"{path} {options} is not refused: {told}")


def expect(condition, *what):
    assert condition, what


def expect_refused(part: str, path, **options):
    message = refusal(path, **options)
    assert part in message, f"'{part}' is not in '{message}'"


def area(loop) -> float:
    x, y = loop.T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))


def near(a, b, within) -> bool:
    return abs(a - b) <= within


def expect_same(loops, wanted, within):
    """Each loop has the corners of the wanted one, from whichever it begins."""
    assert len(loops) == len(wanted), (len(loops), len(wanted))
    for one in wanted:
        one = np.asarray(one, float)
        one = one if area(one) > 0 else one[::-1]
        matches = [loop for loop in loops if len(loop) == len(one) and
                   min(np.abs(np.roll(loop, k, 0) - one).max() for k in range(len(one))) <= within]
        assert matches, (one, loops)


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def off_circle(loop, centre, radius) -> float:
    """How far corners and middles of sides are off a circle."""
    middles = 0.5 * (loop + np.roll(loop, -1, 0))
    return max(abs(np.hypot(*(points - centre).T) - radius).max() for points in (loop, middles))


def fork():
    return [tuple(map(float, line.split(","))) for line in (source / "cases/07-fork/fork.csv").read_text().splitlines()
            if not line.startswith("#")]


def run_tests(module):
    tests = [(name, test) for name, test in vars(module).items() if name.startswith("test_")]
    failed = 0
    for name, test in tests:
        start = time.monotonic()
        try:
            test()
        except Exception as error:  # each is told
            import traceback
            failed += 1
            print(f"FAILED {name}")
            traceback.print_exc()
        print(f"{time.monotonic() - start:5.1f} s  {name}", flush=True)
    print(f"{len(tests) - failed} of {len(tests)} passed")
    sys.exit(1 if failed else 0)
