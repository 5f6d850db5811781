#!/usr/bin/env bash
# Checks that docs/components.md is the program's output.
exec scripts/page-is-fresh docs/components.md scripts/components build/trembler
