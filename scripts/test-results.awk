# The results of the tests in a log of "ctest --verbose": lines of "ok COUNT", "skip NAME", "fail NUMBER NAME", and
# "leakless NUMBER NAME" for groups of which only the leak sanitizer crashed, after all cases had passed. NUMBER is ctest's.
# A case of a test program counts as a test, and so does any other test of ctest's. A program's group of cases is called
# test_PROGRAM.GROUP.
match($0, /^[0-9]+: /) {
    number = substr($0, 1, RLENGTH - 2)
    line = substr($0, RLENGTH + 1)
    if (line ~ /^\[ RUN      \] /) {
        last[number] = substr(line, 14)
    } else if (line ~ /^\[       OK \] /) {
        ok++
    } else if (line ~ /^\[  (SKIPPED |FAILED  )\] .* \([0-9]+ ms\)$/) {
        name = substr(line, 14)
        sub(/(, where | \().*/, "", name)
        if (line ~ /SKIPPED/) {
            print "skip", name
        } else {
            failed[number]++
            print "fail", number, name
        }
    } else if (line ~ /^\[  PASSED  \] /) {
        passed[number] = 1
    } else if (line ~ /^Tracer caught signal/) {
        tracer[number] = 1
    }
    next
}
match($0, /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: /) {
    name = substr($0, RLENGTH + 1)
    sub(/ .*/, "", name)
    number = substr($0, 1, RLENGTH - 2)
    sub(/.*#/, "", number)
    group = name ~ /^test_.*\.[0-9]+$/
    if ($0 ~ / Passed +[0-9.]+ sec/) {
        ok += !group
    } else if ($0 ~ /\*\*\*Skipped/) {
        print "skip", name
    } else if (!group) {
        print "fail", number, name
    } else if (failed[number]) {
        # its cases are printed above
    } else if (passed[number] && tracer[number]) {
        print "leakless", number, name
    } else if (passed[number]) {
        print "fail", number, name " after its last case"
    } else {
        print "fail", number, name (last[number] == "" ? "" : " in " last[number])
    }
}
END { print "ok", ok + 0 }
