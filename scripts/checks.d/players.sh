#!/usr/bin/env bash
# Checks that the keys and mouse actions in docs/players.md are those of the program.
exec scripts/page-is-fresh docs/players.md scripts/players build/trembler
