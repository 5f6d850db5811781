# shellcheck shell=bash
# No effect depends on where an object comes from (runtime/object/origin.hpp): what it does follows from its properties.
# Components and completions cannot ask, as it is no property; rules and connectors could, and must not.
set -euo pipefail
if grep -rnE --include='*.[ch]pp' --include='*.inc' '\b(originOf|prototypeOf|Origin)\b' physics audio/effect; then
    echo "an effect asks where an object comes from"
    exit 1
fi
