#!/usr/bin/env bash
# Checks that THIRD_PARTY.md corresponds to scripts/packages.
set -euo pipefail
if ! scripts/third-party | diff -u THIRD_PARTY.md -; then
    echo "THIRD_PARTY.md is stale: scripts/third-party >THIRD_PARTY.md"
    exit 1
fi
