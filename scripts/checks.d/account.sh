#!/usr/bin/env bash
# Checks that docs/account.md is the program's output for Experiment I.
exec scripts/page-is-fresh docs/account.md scripts/account build/trembler
