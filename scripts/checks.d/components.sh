#!/usr/bin/env bash
# Is docs/components.md what the program says of itself?
set -euo pipefail
if [[ ! -x build/trembler ]]; then
    echo "build/trembler has not been built"
    exit 77
fi
if ! scripts/components build/trembler | diff -u docs/components.md -; then
    echo "docs/components.md is stale: scripts/components build/trembler >docs/components.md"
    exit 1
fi
