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

for command in $("$scree" --help | sed -n '/^Subcommands/,$ s/^  \([a-z]*\) .*/\1/p'); do
  grep -q "^\.B $command\b" "$work/usr/share/man/man1/scree.1" || fail "the manual does not name 'scree $command'"
done

cp -r "$source/docs/examples/embed" embed
cmake -G Ninja -S embed -B embed/build -DCMAKE_PREFIX_PATH="$work/usr" -DCMAKE_BUILD_TYPE=Release >embed.log 2>&1 ||
  { cat embed.log; fail 'find_package(scree) fails'; }
cmake --build embed/build >>embed.log 2>&1 || { cat embed.log; fail 'the example does not build'; }
embed/build/slide || fail 'the example is wrong'
