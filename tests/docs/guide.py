"""The commands of a page of docs/guide do what the page says: its blocks of sh, then those of python, in one folder.
A page that needs modules which Python lacks is skipped (77).

usage: guide.py SOURCE_DIR TANKTREAD PAGE
"""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile

source, program, page = (pathlib.Path(word).resolve() for word in sys.argv[1:])
text = page.read_text()
blocks = {language: "\n".join(re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)) for language in ("sh", "python")}
if not any(blocks.values()):
    sys.exit(f"{page} has no commands")
for target in re.findall(r"\]\(([^)#:]+)\)", text):
    if not (page.parent / target).exists():
        sys.exit(f"{page} names {target}, which is not there")
needed = re.search(r"<!-- needs: (.*?) -->", text)
missing = [name for name in needed[1].split() if importlib.util.find_spec(name) is None] if needed else []
if missing:
    print(f"skipped: python3 has no {', '.join(missing)} (tools/install test)")
    sys.exit(77)
environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}", "PYTHONPATH": str(source / "python"), "MPLBACKEND": "Agg"}
with tempfile.TemporaryDirectory() as folder:
    for command in (["bash", "-e", "-c", blocks["sh"]], [sys.executable, "-c", blocks["python"]]):
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{page}:\n{done.stdout}{done.stderr}")
