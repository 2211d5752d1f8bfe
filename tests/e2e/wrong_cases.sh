#!/usr/bin/env bash
# Wrong case files: exit code 3, one error with its place, the allowed values and a hint; nothing is written.
# usage: wrong_cases.sh SCREE SOURCE_DIR
set -u
scree=$1
cases=$2/tests/fault/cases
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$cases"/* "$work"   # with the records and outlines that some of them name
rm -f "$work/good.toml"
python3 - "$work" <<'END'
import sys
with open(sys.argv[1] + "/deep_header.toml", "w") as f: f.write("[" + ".".join("a" * 200000) + "]\n")
with open(sys.argv[1] + "/deep_key.toml", "w") as f: f.write(".".join("a" * 200000) + " = 1\n")
END
failed=0 count=0
for file in "$work"/*.toml; do
  name=$(basename "$file")
  "$scree" run "$file" --out "$work/out" >"$work/stdout" 2>"$work/stderr"
  code=$?
  count=$((count + 1))
  wrong=''
  [ $code = 3 ] || wrong+=" exit code $code"
  [ "$(grep -c ': error: ' "$work/stderr")" = 1 ] || wrong+=" not one error"
  grep -qE "[^/]*\.(toml|AT2|csv):[0-9]+:[0-9]+: error: " "$work/stderr" || wrong+=" no place"
  grep -q '^  allowed: ' "$work/stderr" || wrong+=" no allowed range"
  grep -q '^  hint: ' "$work/stderr" || wrong+=" no hint"
  [ -s "$work/stdout" ] && wrong+=" talks on stdout"
  [ -e "$work/out" ] && wrong+=" wrote something"
  if [ -n "$wrong" ]; then
    echo "$name:$wrong"
    cat "$work/stderr"
    failed=1
  fi
done
echo "$count wrong cases tried"
[ $count -ge 101 ] && [ $failed = 0 ]
