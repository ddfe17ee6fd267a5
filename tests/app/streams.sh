#!/usr/bin/env bash
# A run goes on with its standard streams closed, full or without a reader, and ends with 0.
# usage: streams.sh PROGRAM SOURCE
set -u
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
start() { "$program" run "$2/cases/05-channel/case.toml" -j 1 --fresh --set numerics.dx="1 um" --set time.end="0.2 ms" -o "$folder/$1"; }
expect() { [ "$1" = 0 ] && [ -s "$folder/$2/summary.json" ] || { echo "$2: exit code $1"; exit 1; }; }

start errors "$2" 2>&- >/dev/null; expect $? errors
start output "$2" 2>/dev/null >&-; expect $? output
start all "$2" <&- >&- 2>&-; expect $? all
start full "$2" >/dev/null 2>/dev/full; expect $? full
# What only prints tells that it could not; a reader that has seen enough is told nothing.
for words in keys "check $2/cases/05-channel/case.toml" --version "help run"; do
  message=$("$program" $words 2>&1 >/dev/full); code=$?
  [ $code = 5 ] && [ "$message" = "tanktread: cannot write to the standard output" ] || { echo "$words: $code $message"; exit 1; }
done
message=$({ "$program" keys | true; } 2>&1); [ -z "$message" ] || { echo "keys | true: $message"; exit 1; }
start reader "$2" 2>&1 >/dev/null | true; expect "${PIPESTATUS[0]}" reader
