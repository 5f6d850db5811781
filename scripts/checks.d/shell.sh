# shellcheck shell=bash
# The shell scripts themselves. (A script here is one test: exit 0 passes, 77 skips, anything else fails.)
set -euo pipefail
shellcheck -x play check .ci/run scripts/install scripts/lib.sh scripts/moving-picture scripts/page-is-fresh scripts/tidy scripts/tbb-for-tsan scripts/third-party scripts/checks.d/*.sh
