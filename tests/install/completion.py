"""Shells complete the words of tanktread as a user sees it: keys are sent to a shell on a terminal of its own.

usage: completion.py TANKTREAD INSTALLED_SHARE. What the shell makes of a line is what a stand-in for the program then prints.
"""
import os
import pathlib
import pty
import select
import shutil
import sys
import tempfile
import time

program, share = (pathlib.Path(word).resolve() for word in sys.argv[1:])
LINES = {  # as typed, a tab after it: the words that the shell then has
    "tanktread sel": ["selftest"],
    "tanktread run slow.toml --fre": ["run", "slow.toml", "--fresh"],
    "tanktread run slow.toml --progress js": ["run", "slow.toml", "--progress", "json"],
    "tanktread run slow.toml --progress=js": ["run", "slow.toml", "--progress=json"],
    "tanktread run sl": ["run", "slow.toml"],
    "tanktread report res": ["report", "results"],
    "tanktread run slow.toml --set flow.dri": ["run", "slow.toml", "--set", "flow.drive="],
    "tanktread run slow.toml --set flow.drive=pr": ["run", "slow.toml", "--set", "flow.drive=pressure"],
    "tanktread run slow.toml --set membrane.hardening.apply_to=shear,be":
        ["run", "slow.toml", "--set", "membrane.hardening.apply_to=shear,bending"],
    "tanktread export results --to v": ["export", "results", "--to", "vtk"],
    "tanktread keys domain.le": ["keys", "domain.length"],
    "tanktread help stat": ["help", "status"],
}
SHELLS = {
    "bash": (["bash", "--norc", "--noprofile", "-i"], ["source /usr/share/bash-completion/bash_completion",
                                                       f"source {share}/bash-completion/completions/tanktread"]),
    "zsh": (["zsh", "-f", "-i"], [f"fpath=({share}/zsh/vendor-completions $fpath)", "autoload -Uz compinit", "compinit -u -D"]),
}


class Terminal:
    """A shell on a terminal. `answer` waits for a line that ends what the last command printed."""

    def __init__(self, command, folder):
        self.pid, self.fd = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.environ.update(PATH=f"{folder}/bin:{os.environ['PATH']}", TERM="dumb", HOME=str(folder), PS1="> ", LC_ALL="C.UTF-8")
            os.execvp(command[0], command)

    def send(self, text):
        os.write(self.fd, text.encode())

    def until(self, mark, seconds=30):
        seen, end = "", time.monotonic() + seconds
        while mark not in seen:
            if time.monotonic() > end:
                raise TimeoutError(f"no {mark!r} in {seen!r}")
            if select.select([self.fd], [], [], 0.1)[0]:
                seen += os.read(self.fd, 65536).decode(errors="replace")
        return seen

    def close(self):
        os.close(self.fd)
        os.waitpid(self.pid, 0)


def stand_in(folder):
    """A program that answers the shell's questions as tanktread does, and prints its words otherwise."""
    (folder / "bin").mkdir()
    path = folder / "bin/tanktread"
    path.write_text(f'#!/bin/sh\n[ "$1" = complete ] && exec "{program}" "$@"\nfor word; do printf "[%s]" "${{word%/}}"; done; echo " fi""n"\n')
    path.chmod(0o755)
    (folder / "slow.toml").touch()
    (folder / "slow.txt").touch()
    (folder / "results").mkdir()


def faults_of(shell):
    command, setup = SHELLS[shell]
    faults = []
    with tempfile.TemporaryDirectory() as name:
        stand_in(pathlib.Path(name))
        terminal = Terminal(command, name)
        terminal.send("".join(line + "\n" for line in setup) + "echo rea''dy\n")
        terminal.until("ready")
        for line, words in LINES.items():
            terminal.send(line + "\t\n")
            seen = terminal.until(" fin")
            wanted = "".join(f"[{word}]" for word in words)
            if wanted not in seen:
                faults.append(f"{shell}: '{line}' became {seen!r}, not {wanted}")
        terminal.close()
    return faults


present = [shell for shell in SHELLS if shutil.which(shell)]
faults = [fault for shell in present for fault in faults_of(shell)]
print("\n".join(faults) or f"{len(LINES)} lines completed by {' and by '.join(present)}")
sys.exit(1 if faults else 0)
