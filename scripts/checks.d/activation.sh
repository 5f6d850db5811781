#!/usr/bin/env bash
# Checks that docs/measurements/activation.md is the program's output. Plays all levels, in about a second.
exec scripts/page-is-fresh docs/measurements/activation.md build/trembler components --levels --markdown
