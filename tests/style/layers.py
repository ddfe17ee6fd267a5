"""A folder of src/ includes itself and folders with a smaller number, never an equal or larger one (src/LAYERS)."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
layers = {}
for line in (root / "src/LAYERS").read_text().splitlines():
    if line and not line.startswith("#"):
        number, folder = line.split()
        layers[folder] = int(number)

faults = []
for folder in sorted(p.name for p in (root / "src").iterdir() if p.is_dir()):
    if folder not in layers:
        faults.append(f"src/{folder} is not named in src/LAYERS")
checked = 0
for path in sorted((root / "src").rglob("*.[ch]pp")):
    folder = path.relative_to(root / "src").parts[0]
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = re.match(r'\s*#\s*include\s+"([^"/]+)/', line)
        if not match:
            continue
        checked += 1
        target = match.group(1)
        if target != folder and layers.get(target, 99) >= layers.get(folder, -1):
            faults.append(f"{path.relative_to(root)}:{number}: {folder} ({layers.get(folder)}) must not include "
                          f"{target} ({layers.get(target)})")
print("\n".join(faults) or f"{checked} includes, none upwards or sideways")
sys.exit(1 if faults or checked == 0 else 0)
