#!/usr/bin/env bash
# Installs the build into a folder and uses it as an installed product: the command with its cases, a program that
# finds the libraries by CMake, completions that the shells accept, a manual that names every command.
# usage: package.sh BUILD SOURCE
set -euo pipefail
build=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "package.sh: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$work/usr" >"$work/install.log"
scree=$work/usr/bin/scree
cd "$work"
"$scree" --version | grep '^[0-9]' >/dev/null || fail 'no version'
"$scree" cases list | grep '^incline' >/dev/null || fail 'the installed command does not find the case library'
strings=$("$scree" cases list | wc -l)
[ "$strings" -ge 10 ] || fail "only $strings cases"
"$scree" cases verify sdof >/dev/null || fail 'a case of the installed library fails'

for shell in bash zsh fish; do
  "$scree" completion $shell >"completion.$shell"
  grep -q overwrite "completion.$shell" || fail "the completion for $shell misses an option"
  if command -v $shell >/dev/null; then $shell -n "completion.$shell" || fail "$shell does not take its completion"; fi
done
found=$(bash -c '. ./completion.bash; COMP_WORDS=(scree cases verify --f); COMP_CWORD=3; _scree; echo "${COMPREPLY[@]}"')
[ "$found" = --full ] || fail "bash completes 'scree cases verify --f' to '$found'"
found=$(bash -c '. ./completion.bash; COMP_WORDS=(scree sn); COMP_CWORD=1; _scree; echo "${COMPREPLY[@]}"')
[ "$found" = snapshot ] || fail "bash completes 'scree sn' to '$found'"

words() { bash -c '. ./completion.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _scree; echo "${COMPREPLY[*]}"' - "$@"; }
[ "$(words scree snapshot --field sx)" = 'sxx sxy' ] || fail "bash completes no fields: $(words scree snapshot --field sx)"
[ "$(words scree cases verify inc)" = incline ] || fail 'bash completes no names of cases'
for word in speed incline handover; do
  for shell in zsh fish; do grep -q "\b$word\b" "completion.$shell" || fail "the completion for $shell lacks '$word'"; done
done

# The live stream of the installed command, read by the installed example with the installed types.
ls "$work"/usr/share/scree/lcmtypes/*.lcm >/dev/null || fail 'the types of the live stream are not installed'
python3 "$work/usr/share/doc/scree/examples/read_live.py" --timeout 0.2 >live.log 2>&1 || true
grep -q 'FileNotFound\|KeyError\|Traceback' live.log && { cat live.log; fail 'the installed read_live.py does not find its types'; }

# Programs that link the libraries, and packages, are compiled for any machine, without -march=native.
grep -rq -- '-march' "$work"/usr/lib/*/cmake/scree "$work"/usr/lib/cmake/scree 2>/dev/null && fail 'the exported targets carry -march'
if grep -q '^SCREE_NATIVE:BOOL=ON' "$build/CMakeCache.txt"; then
  if (cd "$build" && cpack -G DEB -B "$work/cpack" >"$work/cpack.log" 2>&1); then fail 'cpack packs a build for one machine'; fi
  grep -q 'preset package' "$work/cpack.log" || { cat "$work/cpack.log"; fail 'cpack does not name the preset to use'; }
fi

for command in $("$scree" --help | sed -n '/^Subcommands/,$ s/^  \([a-z]*\) .*/\1/p'); do
  grep -q "^\.B $command\b" "$work/usr/share/man/man1/scree.1" || fail "the manual does not name 'scree $command'"
done

cp -r "$source/docs/examples/embed" embed
cmake -G Ninja -S embed -B embed/build -DCMAKE_PREFIX_PATH="$work/usr" -DCMAKE_BUILD_TYPE=Release >embed.log 2>&1 ||
  { cat embed.log; fail 'find_package(scree) fails'; }
cmake --build embed/build >>embed.log 2>&1 || { cat embed.log; fail 'the example does not build'; }

# A method from a shared library, with a key of its own: it runs and resumes, `scree schema` lists it, and wrong
# libraries are refused.
load=(--load embed/build/librigid_method.so)
"$scree" schema "${load[@]}" | grep 'inertia_factor' >/dev/null || fail 'schema does not tell the keys of a loaded method'
"$scree" check embed/rigid.toml "${load[@]}" | grep "stage 'fall': rigid" >/dev/null || fail 'check does not know a loaded method'
for factor in 1 2; do
  "$scree" run embed/rigid.toml "${load[@]}" --set method.rigid.inertia_factor=$factor --set stage.0.duration=0.1 \
    --out rigid.$factor --quiet || fail 'a loaded method does not run'
done
python3 - <<'END' || fail 'the constant of a loaded method does not act'
import json
# The block that spins with 1 rad/s has a kinetic energy larger by I/2: I = m a^2/6 of a square, 2500 kg, 1 m; the fall
# adds the same to both.
energy = [json.load(open(f"rigid.{n}/summary.json"))["ledger"]["columns"]["energy"]["kinetic"] for n in (1, 2)]
assert abs(energy[1] - energy[0] - 2500.0 / 12.0) < 1e-6 * energy[0], energy
END
"$scree" run embed/rigid.toml "${load[@]}" --until 0.1 --out rigid.parts --quiet || fail 'a loaded method does not stop'
"$scree" resume rigid.parts "${load[@]}" --until 0.2 --quiet || fail 'a run with a loaded method does not resume'
"$scree" run embed/rigid.toml "${load[@]}" --out rigid.whole --quiet
state() { sed -n 's/.*"state_hash": "\(.*\)".*/\1/p' "$1/summary.json"; }
[ "$(state rigid.parts)" = "$(state rigid.whole)" ] || fail 'a run with a loaded method resumes to other bits'
refused() { # CODE WORDS COMMAND...
  local code=$1 words=$2 found=0; shift 2
  "$scree" "$@" >refused.log 2>&1 || found=$?
  [ $found = "$code" ] && grep -q -- "$words" refused.log || { cat refused.log; fail "scree $* ends with $found"; }
}
refused 3 '--load LIBRARY' check embed/rigid.toml
refused 2 'no such file' check embed/rigid.toml --load absent.so
refused 2 'it is no library of Scree' check embed/rigid.toml --load "$(ldd "$scree" | sed -n 's/.*=> \(.*libz\.so[^ ]*\) .*/\1/p')"
refused 2 'cannot be loaded' check embed/rigid.toml --load embed/rigid.toml
refused 2 'there is one of that name' check embed/rigid.toml "${load[@]}" --load embed/../embed/build/librigid_method.so
refused 3 'out of range' check embed/rigid.toml "${load[@]}" --set method.rigid.inertia_factor=-1
refused 3 'inertia_facto' check embed/rigid.toml "${load[@]}" --set method.rigid.inertia_facto=1

for program in slide own_law; do embed/build/$program || fail "the example $program is wrong"; done
