#!/usr/bin/env bash
# Is docs/called-for.md what levels call for? Plays all of them, in about a second.
set -euo pipefail
if [[ ! -x build/trembler ]]; then
    echo "build/trembler has not been built"
    exit 77
fi
if ! build/trembler components --levels --markdown | diff -u docs/called-for.md -; then
    echo "docs/called-for.md is stale: build/trembler components --levels --markdown >docs/called-for.md"
    exit 1
fi
