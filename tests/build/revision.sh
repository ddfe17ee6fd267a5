#!/usr/bin/env bash
# The program names the commit of its own repository, whether files differ from it, and of a tarball what git put there.
# usage: revision.sh SOURCE
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export HOME=$folder GIT_CONFIG_NOSYSTEM=1

# what the build in $1 would name
revision_in() {
    cmake -DSOURCE="$1" -DOUT="$folder/revision.cpp" -P "$1/cmake/revision.cmake"
    grep "revision{" "$folder/revision.cpp"
}
expect() {
    [ "$2" = "const Revision revision{$3};" ] || { echo "$1: $2 is not {$3}"; exit 1; }
}

mkdir -p "$folder/tree" "$folder/plain"
cp -r "$1/cmake" "$1/.gitattributes" "$folder/tree"
cd "$folder/tree"
expect "no repository" "$(revision_in .)" '"", false'

git init -q .
git add .
git -c user.name=test -c user.email=test@localhost commit -q -m first
commit=$(git rev-parse HEAD)
expect "a commit" "$(revision_in .)" "\"$commit\", false"
stamp=$(stat -c %y "$folder/revision.cpp")
revision_in . >/dev/null
[ "$stamp" = "$(stat -c %y "$folder/revision.cpp")" ] || { echo "written again though nothing changed"; exit 1; }
echo >>cmake/dependencies.cmake
expect "a change" "$(revision_in .)" "\"$commit\", true"

git archive HEAD | tar -x -C "$folder/plain"
expect "a tarball" "$(revision_in "$folder/plain")" "\"$commit\", false"
mkdir inner
cp -r "$1/cmake" inner
expect "within another repository" "$(revision_in inner)" '"", false'
