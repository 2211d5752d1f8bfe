#!/usr/bin/env bash
# Installs the build into a folder, and uses it from there as others would: the command with its cases, a program that
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
"$scree" --version | grep -q '^[0-9]' || fail 'no version'
"$scree" cases list | grep -q '^incline' || fail 'the installed command does not find the case library'
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

# Whoever links the libraries compiles for any machine, and so are packages.
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
embed/build/slide || fail 'the example is wrong'
