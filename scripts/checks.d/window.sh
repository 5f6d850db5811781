#!/usr/bin/env bash
# Checks that docs/measurements/window.md has a row for each level, also of the mods that come with the program. Its times
# are of one machine, so they are not measured again.
set -euo pipefail
page=docs/measurements/window.md
missing=$(for level in levels/*/[0-9]*.json mods/*/levels/*.json; do
    [[ -e $level ]] || continue
    grep -qF "| ${level%.json} |" "$page" || echo "  ${level%.json}"
done)
if [[ $missing ]]; then
    echo "$page has no row for:"
    echo "$missing"
    echo "Make it again on an idle machine: xvfb-run -a build/bench/bench_window --markdown >$page"
    exit 1
fi
