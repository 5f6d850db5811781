#!/usr/bin/env bash
# Are the keys in docs/players.md those of the program?
exec scripts/page-is-fresh docs/players.md scripts/players build/trembler
