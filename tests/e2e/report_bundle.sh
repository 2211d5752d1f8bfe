#!/usr/bin/env bash
# The committed bundle of the page (io/viewer/dist) equals the bundle built from its sources, and the sources pass the
# type check.
# Usage: report_bundle.sh SOURCE BUILD
set -euo pipefail
source=$1 build=$2
# shellcheck source=tests/e2e/report_modules.sh
. "$(dirname "$0")/report_modules.sh"
viewer_modules "$source" "$build"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
cp -r "$source"/io/viewer/{src,build.mjs,package.json,tsconfig.json} "$out"
ln -s "$modules" "$out/node_modules"
(cd "$out" && node node_modules/typescript/bin/tsc --noEmit)
(cd "$out" && node build.mjs --out "$out/dist")
diff -rq "$out/dist" "$source/io/viewer/dist" || { echo "report_bundle: FAILED: io/viewer/dist is not built from io/viewer/src; run tools/viewer.sh" >&2; exit 1; }
echo "bundle: that of the sources"
