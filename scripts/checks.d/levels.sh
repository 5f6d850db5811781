#!/usr/bin/env bash
# Checks that docs/measurements/levels.md says of the first chapter what the program says, in some seconds; the page as a
# whole takes minutes.
set -euo pipefail
if [[ ! -x build/trembler ]]; then
    echo "build/trembler has not been built"
    exit 77
fi
page=docs/measurements/levels.md
if [[ ! -e $page ]]; then
    echo "$page has not been made: scripts/levels-report build/trembler >$page"
    exit 77
fi
# Its sections follow each other in the page as well.
short=$(scripts/levels-report build/trembler --short)
if [[ $(<"$page") != *"$short"* ]]; then
    diff -u <(sed -n '/^### levels\/first\//,/^### levels\/[^f]/p' "$page" | sed '/^### levels\/[^f]/d') <(echo "$short") || true
    echo "$page is stale: scripts/levels-report build/trembler >$page"
    exit 1
fi
