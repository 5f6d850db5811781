#!/usr/bin/env bash
# Checks that docs/measurements/levels.md agrees with the program on the first chapter, and for every level on the number of
# solutions and of their kinds and on the first displaced and dropped runs, frame by frame, in less than a minute; making the
# whole page takes many minutes. No level may miss the requirements of docs/solving.md for a puzzle: two kinds of solution and
# none with an empty toolbox, which are computed here, and the shares of all displaced and dropped runs, which are read from
# the page.
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
short_of=$(grep '^| levels/' "$page" | awk -F'|' '$7 !~ /^ *$/')
if [[ -n $short_of ]]; then
    printf 'levels that fall short of what is expected of a puzzle:\n%s\n' "$short_of"
    exit 1
fi
tables=$(scripts/levels-report build/trembler --tables)
kinds() { awk -F'|' '/^\| levels\// && NF == 8' | cut -d '|' -f 2-4,7; }
first_runs() { grep -E '^\| levels/([^|]*\|){3}$'; }
if ! diff -u <(kinds <"$page") <(kinds <<<"$tables") ||
    ! diff -u <(first_runs <"$page") <(first_runs <<<"$tables"); then
    echo "$page is stale: scripts/levels-report build/trembler >$page"
    exit 1
fi
