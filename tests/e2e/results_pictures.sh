#!/usr/bin/env bash
# `scree snapshot` as a user types it: every kind of picture, and wrong options that draw nothing.
# Usage: results_pictures.sh SCREE RUN
set -euo pipefail
scree=$1 run=$2
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
fail() { echo "results_pictures: FAILED: $*" >&2; exit 1; }

draw() {  # file, first bytes, options
  local file=$out/$1 magic=$2
  shift 2
  [ "$("$scree" snapshot "$run" --out "$file" "$@")" = "$file" ] || fail "does not say where it put $file"
  [ "$(head -c ${#magic} "$file" | tr -d '\0')" = "$magic" ] || fail "$file does not begin with $magic"
}
draw a.png $'\x89PNG' --at handover --field speed --arrows velocity --width 800
draw b.pdf '%PDF-' --field syy --range -5e5 1e5 --at 0.7s
draw c.svg '<?xml' --field block --labels --window 15 10 45 35
draw d.png $'\x89PNG' --at 3 --field material
draw h.png $'\x89PNG' --at settle --field s3
draw e.PDF '%PDF-' --history crest toe
draw f.svg '<?xml' --history
draw g.svg '<?xml' --ledger
grep -q '<svg' "$out/c.svg" || fail "c.svg is no SVG"

refuse() {  # exit code, part of the message, options
  local code=0 message
  message=$("$scree" snapshot "$run" --out "$out/${name:-none.png}" "${@:3}" 2>&1) || code=$?
  [ "$code" = "$1" ] || fail "exit code $code, not $1, of ${*:3}"
  [[ $message == *"$2"* ]] || fail "${*:3} gives \"$message\", without \"$2\""
  [ ! -e "$out/${name:-none.png}" ] || fail "${*:3} draws all the same"
}
refuse 2 'allowed: displacement, speed' --field colour
refuse 2 'smaller one first' --range 2 1
refuse 2 'x0 < x1' --window 5 5 5 9
refuse 2 'allowed: 0 to ' --at 99999
refuse 2 'start, end, handover' --at noon
refuse 2 'none, displacement, velocity' --arrows force
name=none.jpg refuse 2 'end in .png, .pdf or .svg' --field speed
refuse 2 'excludes' --ledger --history
refuse 5 'no monitor nobody; there are' --history nobody
echo "pictures: fine"
