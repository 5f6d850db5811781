#!/usr/bin/env bash
# Is docs/account.md what the program prints of Experiment I?
set -euo pipefail
if [[ ! -x build/trembler ]]; then
    echo "build/trembler has not been built"
    exit 77
fi
if ! scripts/account build/trembler | diff -u docs/account.md -; then
    echo "docs/account.md is stale: scripts/account build/trembler >docs/account.md"
    exit 1
fi
