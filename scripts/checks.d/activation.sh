#!/usr/bin/env bash
# Is docs/activation.md what levels call for? Plays all of them, in about a second.
exec scripts/page-is-fresh docs/activation.md build/trembler components --levels --markdown
