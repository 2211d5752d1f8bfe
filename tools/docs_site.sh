#!/usr/bin/env bash
# Builds the pages of docs/ as a site in build/site, which needs no network: open build/site/index.html.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
# shellcheck source-path=SCRIPTDIR/.. source=tools/packages.sh
. tools/packages.sh

case ${1:-} in
  '') ;;
  -h | --help)
    cat <<'END'
usage: tools/docs_site.sh [--help]

Installs the Debian packages that are missing (packages.txt, section [docs]), checks the links of docs/ and builds the
site in build/site.
END
    exit 0 ;;
  *)
    echo "docs_site.sh: unknown option $1; see tools/docs_site.sh --help" >&2
    exit 2 ;;
esac

packages_install docs
python3 -B tests/docs/check_docs.py "$root"
mkdocs build --quiet --clean --strict --config-file tools/mkdocs.yml
mkdir -p build/site/katex/contrib
katex=/usr/share/javascript/katex
cp -L "$katex/katex.min.css" "$katex/katex.min.js" build/site/katex/
cp -L "$katex/contrib/mathtex-script-type.js" build/site/katex/contrib/
cp -rL "$katex/fonts" build/site/katex/
# Pictures of cases are in the folders of the cases.
for picture in cases/*/picture.png; do
  name=$(basename "$(dirname "$picture")")
  cp "$picture" "build/site/images/case-$name.png"
done
sed -i -E 's#\.\./cases/([a-z-]+)/picture\.png#images/case-\1.png#g' build/site/cases.html
echo "build/site/index.html"
