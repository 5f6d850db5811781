# shellcheck shell=bash
# Checks the shell scripts with shellcheck. (Each script in this folder is one test: exit status 0 passes, 77 skips, others
# fail.)
set -euo pipefail
shellcheck -x play check .ci/run scripts/install scripts/levels-report scripts/lib.sh scripts/moving-picture scripts/page-is-fresh scripts/tidy scripts/tbb-for-tsan scripts/third-party scripts/checks.d/*.sh
