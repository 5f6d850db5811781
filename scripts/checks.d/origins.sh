# shellcheck shell=bash
# Checks that no effect depends on the origin of an object (runtime/object/origin.hpp), only on its properties.
# Components and completions have no access to origins, which are not properties; rules and connectors have, and must not
# use it.
set -euo pipefail
if grep -rnE --include='*.[ch]pp' --include='*.inc' '\b(originOf|prototypeOf|Origin)\b' physics audio/effect; then
    echo "an effect asks where an object comes from"
    exit 1
fi
