#!/usr/bin/env bash
# Is docs/measurements/activation.md what levels call for? Plays all of them, in about a second.
exec scripts/page-is-fresh docs/measurements/activation.md build/trembler components --levels --markdown
