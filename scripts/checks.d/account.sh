#!/usr/bin/env bash
# Is docs/account.md what the program prints of Experiment I?
exec scripts/page-is-fresh docs/account.md scripts/account build/trembler
