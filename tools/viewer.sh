#!/usr/bin/env bash
# Builds the page of `scree report` anew: io/viewer/src -> io/viewer/dist. Requires Node 18 or later and npm.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case ${1:-} in
  '') ;;
  *)
    echo "usage: tools/viewer.sh     installs what io/viewer/package-lock.json names, checks types, writes io/viewer/dist" >&2
    [ "$1" = --help ] || exit 2
    exit 0 ;;
esac
cd "$root/io/viewer"
npm ci --ignore-scripts --no-audit --no-fund
npm run --silent check
npm run --silent build
ls -l dist
