#!/usr/bin/env bash
# build.sh PROGRAMS OUT: the site in OUT/site, from the manual and what the programs tell of
# themselves. A warning, a page outside of the menu and a link that leads nowhere are errors.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
export COPPICE_PAGES=$2/pages COPPICE_SITE=$2/site
/usr/bin/python3 "$here/make_pages.py" "$here/../.." "$1" "$COPPICE_PAGES"
mkdocs build --quiet --strict --config-file "$here/mkdocs.yml"
/usr/bin/python3 "$here/check_links.py" "$COPPICE_SITE"
