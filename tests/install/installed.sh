#!/usr/bin/env bash
# What `cmake --install` puts in place works from there: program, manual, completion, cases, Python package, libraries.
# usage: installed.sh BUILD SOURCE
set -euo pipefail
build=$1 source=$2
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
fail() { echo "installed: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$prefix" >"$prefix/log" || fail "$(tail "$prefix/log")"
export PATH=$prefix/bin:$PATH
mkdir "$prefix/elsewhere"
cd "$prefix/elsewhere"

! readelf -d "$prefix/bin/tanktread" | grep -E 'R(UN)?PATH' || fail "the program looks for libraries where it was built"
! grep -rl "$build" "$prefix/bin" "$prefix/lib/cmake" "$prefix/share" || fail "these name the folder of the build"

tanktread new relax --from relax
tanktread check "$prefix/share/tanktread/cases/04-cell-relaxing/case.toml" -j 1 >/dev/null
tanktread run relax.toml -j 1 --progress none --set numerics.dx="1 um" --set time.end="1 ms" -o run >/dev/null 2>log || fail "$(cat log)"
tanktread report run >/dev/null 2>log || fail "$(cat log)"
PYTHONPATH=$prefix/lib/python3/dist-packages /usr/bin/python3 -c '
import tanktread
run = tanktread.Results("run")
assert len(run.frames()) > 1 and run.summary'

verbs=$(tanktread --help | sed -n '/^Verbs:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(wc -w <<<"$verbs")" -ge 10 ] || fail "verbs of the help: $verbs"
for page in $(sed 's/.*/tanktread-&(1)/' <<<"$verbs") 'tanktread(1)' 'tanktread-case(5)'; do
    section=${page: -2:1}
    file=$prefix/share/man/man$section/${page%(*}.$section.gz
    LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l "$file" >page 2>warnings || fail "$page: $(cat warnings)"
    [ ! -s warnings ] || fail "$page: $(cat warnings)"
    grep -q "^NAME" page || fail "$page has no name"
done

/usr/bin/python3 "$source/tests/install/completion.py" "$prefix/bin/tanktread" "$prefix/share"

cmake -S "$source/tests/install/consumer" -B consumer -G Ninja -DCMAKE_PREFIX_PATH="$prefix" >log 2>&1 &&
    cmake --build consumer >>log 2>&1 || fail "$(tail -n 20 log)"
consumer/consumer
