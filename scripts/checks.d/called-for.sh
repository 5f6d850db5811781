#!/usr/bin/env bash
# Is docs/called-for.md what levels call for? Plays all of them, in about a second.
exec scripts/page-is-fresh docs/called-for.md build/trembler components --levels --markdown
