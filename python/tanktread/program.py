"""Runs of the program, started from Python."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping

from .results import Results


class ProgramError(RuntimeError):
    """The program could not do it. The text is the program's message; `code` its exit code."""

    def __init__(self, message: str, code: int):
        super().__init__(message)
        self.code = code


class BadCase(ProgramError):
    """The command or the case is wrong; nothing was run."""


class Unstable(ProgramError):
    """The run blew up. The message tells what to change; the last good state is kept."""


class InUse(ProgramError):
    """The results directory is of another run, or another process uses it."""


UNSTABLE, STOPPED = 3, 75
_ERRORS = {2: BadCase, UNSTABLE: Unstable, 4: InUse}


def run(case: os.PathLike, output: os.PathLike | None = None, *, set: Mapping[str, object] = {}, threads: int | None = None,
        until: str | None = None, max_time: str | None = None, fresh: bool = False, program: str | None = None) -> Results:
    """Runs a case file, or goes on with its results directory, and returns the results.

    `output` is the results directory, else results/NAME. `set` has keys of the case file in place of the file's:
    {"flow.shear_number": 0.2, "time.end": "40 ms"}. A run that `until` ("50 ms" of simulated time) or `max_time` ("55m" on
    the clock) stops is returned as far as it came; the same call goes on. Ctrl-C stops the run with its state saved.
    `program` is the path of tanktread, if not that on PATH.
    Raises BadCase, Unstable, InUse or ProgramError with the program's message.
    """
    words = ["run", os.fspath(case), "--progress", "none", *settings(set)]
    for option, value in [("-o", output), ("-j", threads), ("--until", until), ("--max-time", max_time)]:
        if value is not None:
            words += [option, os.fspath(value) if option == "-o" else str(value)]
    code, out, message = call(program, words + ["--fresh"] * fresh)
    if code == STOPPED:
        return Results(message.rpartition("tanktread resume ")[2].strip())
    raise_if_failed(code, message)
    return Results(out.strip())


def new(case: os.PathLike, template: str = "channel", *, program: str | None = None) -> None:
    """Writes a commented case file, as `tanktread new` does. Raises ProgramError if it is there already."""
    code, _, message = call(program, ["new", os.fspath(case), "--from", template])
    raise_if_failed(code, message)


def check(case: os.PathLike, *, set: Mapping[str, object] = {}, program: str | None = None) -> dict:
    """What `tanktread check --json` tells of a case: grid, time step, numbers of the flow, limits, advice. Runs nothing.

    A case that would be unstable has "ready" false and its cures in "advice". Raises BadCase for faults of the file.
    """
    code, out, message = call(program, ["check", os.fspath(case), "--json", *settings(set)])
    if not out:
        raise_if_failed(code, message)
    return json.loads(out)


def settings(values: Mapping[str, object]) -> list[str]:
    """--set KEY=VALUE of each."""
    return [word for key, value in values.items() for word in ("--set", f"{key}={setting_text(value)}")]


def setting_text(value: object) -> str:
    """A value as it stands after --set KEY=."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(json.dumps(item) if isinstance(item, str) else setting_text(item) for item in value) + "]"
    return str(value)


def call(program: str | None, words: list[str]) -> tuple[int, str, str]:
    """Exit code, standard output and standard error of the program."""
    path = shutil.which(program or "tanktread")
    if path is None:
        raise FileNotFoundError(f"no program '{program or 'tanktread'}' on PATH; give its path as program=")
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as messages:
        process = subprocess.Popen([path, *words], stdin=subprocess.DEVNULL, stdout=out, stderr=messages)
        try:
            process.wait()
        except BaseException:  # Ctrl-C, or the like: the program saves its state and ends
            process.terminate()
            process.wait()
            raise
        texts = []
        for file in (out, messages):
            file.seek(0)
            texts.append(file.read().decode(errors="replace"))
    return process.returncode, *texts


def raise_if_failed(code: int, message: str) -> None:
    """The exception of an exit code."""
    if code != 0:
        raise _ERRORS.get(code, ProgramError)(message.strip(), code)
