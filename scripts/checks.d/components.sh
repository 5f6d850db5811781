#!/usr/bin/env bash
# Is docs/components.md what the program says of itself?
exec scripts/page-is-fresh docs/components.md scripts/components build/trembler
