#!/usr/bin/env bash
# `scree cases verify --jobs`: the same table as without --jobs, also when cases fail.
# Usage: verify_jobs.sh SCREE SOURCE
set -euo pipefail
scree=$1 source=$2
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
fail() { echo "verify_jobs: FAILED: $*" >&2; exit 1; }
export TMPDIR=$out/tmp SCREE_CASES=$out/cases OMP_NUM_THREADS=2
mkdir -p "$out/tmp" "$out/cases"
for name in toppling sdof onefold tunnels-staged compound-surface; do cp -r "$source/cases/$name" "$out/cases/$name"; done
# A study that requires cores of its own and therefore runs last, and one whose case cannot be read.
sed -i '1i cores = 2' "$out/cases/onefold/expected.toml"
cp -r "$out/cases/tunnels-staged" "$out/cases/broken"
echo 'nonsense = 1' >>"$out/cases/broken/case.toml"
names=(toppling sdof onefold tunnels-staged compound-surface)

"$scree" cases verify "${names[@]}" --table "$out/one.csv" >"$out/one.txt"
"$scree" cases verify "${names[@]}" --jobs 3 --table "$out/three.csv" --report "$out/report" >"$out/three.txt"
cmp "$out/one.csv" "$out/three.csv" || fail "another table"
[ "$(tail -n 1 "$out/one.txt")" = "$(tail -n 1 "$out/three.txt")" ] || fail "another last line"
[ "$(grep -c '^[a-z-]* (' "$out/three.txt")" = 5 ] || fail "not a line a case"
[ "$(grep '^[a-z-]* (' "$out/three.txt" | tail -n 1 | cut -d' ' -f1)" = onefold ] || fail "what is to be alone is not last"
diff <(grep '^  ' "$out/one.txt" | grep -v ' steps, ' | sort) <(grep '^  ' "$out/three.txt" | grep -v ' steps, ' | sort) || fail "other rows"
for picture in "$out"/report/*.png; do [ -s "$picture" ] || fail "$picture is empty"; done
ls "$out"/report/sdof-1.png >/dev/null || fail "plots are lost"
[ -z "$(ls -A "$out/tmp")" ] || fail "temporary files are left"

code=0
"$scree" cases verify broken sdof --jobs 2 >"$out/broken.txt" || code=$?
[ $code = 1 ] || fail "exit code $code where a case cannot be evaluated"
grep -q 'exit code 3: .*' "$out/broken.txt" || fail "not told why"
grep -q '^sdof (' "$out/broken.txt" || fail "the other case is lost"
code=0
"$scree" cases verify --jobs 0 sdof >/dev/null 2>"$out/usage.txt" || code=$?
[ $code = 2 ] || fail "exit code $code for no jobs"

# SIGTERM ends the command and all its runs, which last too long to end by themselves.
for name in long longer; do
  cp -r "$source/cases/compound-surface" "$out/cases/$name"
  sed -i -e 's/^duration = 6.0/duration = 1e5/' -e '/^max_displacement/d' "$out/cases/$name/case.toml"
done
"$scree" cases verify long longer --jobs 2 >/dev/null 2>&1 &
pid=$!
for _ in $(seq 600); do
  [ "$(pgrep -c -P $pid)" != 2 ] || break
  sleep 0.05
done
sleep 0.3  # both compute
[ "$(pgrep -c -P $pid)" = 2 ] || fail "the cases ended before they were asked to"
kill -TERM $pid
code=0
wait $pid || code=$?
[ $code = 130 ] || fail "exit code $code when it was asked to end"
[ -z "$(ls -A "$out/tmp")" ] || fail "temporary files are left when it is asked to end"
! pgrep -f "$out" >/dev/null || fail "cases go on"
echo "verify_jobs: ok"
