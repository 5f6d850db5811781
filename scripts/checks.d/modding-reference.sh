#!/usr/bin/env bash
# Checks that docs/modding-reference.md is the program's output.
exec scripts/page-is-fresh docs/modding-reference.md scripts/modding-reference build/trembler
