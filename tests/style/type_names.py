"""A name of a type means one type: two of one name in two files would be mixed up by the linker without a word."""
import collections
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
private = re.compile(r"^namespace \{$.*?^\}  // namespace$", re.MULTILINE | re.DOTALL)
definition = re.compile(r"^(?:template <[^\n]*>\n)?(?:struct|class|enum class) (\w+(?:<[\w:, ]+>)?)[^;\n]*\{", re.MULTILINE)
places = collections.defaultdict(set)
for path in sorted((root / "src").rglob("*.[ch]pp")):
    for name in definition.findall(private.sub("", path.read_text())):
        places[name].add(str(path.relative_to(root)))
faults = [f"{name} is defined in {' and in '.join(sorted(files))}" for name, files in places.items() if len(files) > 1]
print("\n".join(faults) or f"{len(places)} types, no name twice")
sys.exit(1 if faults or not places else 0)
