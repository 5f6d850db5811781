# shellcheck shell=bash
# A test has the name of the source that it tests, or is in a whole/: docs/contributors.md, "Tests".
set -euo pipefail
wrong=0
while IFS= read -r test; do
    case $test in
    */whole/* | tests/determinism/* | tests/levels/* | tests/worlds/*) continue ;;
    esac
    name=${test#tests/}
    name=${name%_test.cpp}
    # x_ASPECT_test.cpp tests x, as x_test.cpp does; the helpers of tests have tests of their own.
    until [[ -e $name.cpp || -e $name.hpp || -e tests/$name.cpp || -e tests/$name.hpp ]]; do
        if [[ ${name##*/} != *_* ]]; then
            echo "$test tests no source of that name"
            wrong=1
            break
        fi
        name=${name%_*}
    done
done < <(find tests -name '*_test.cpp' | sort)
exit "$wrong"
