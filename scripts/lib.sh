# shellcheck shell=bash
# Shared by ./play and ./check: paths, and functions that configure and build a build folder.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
# jobs_at GIGABYTES: one job per processor, but no more than memory allows at so much for each.
jobs_at() {
    awk -v most="$(nproc)" -v each="${1}e6" '/^MemAvailable/ { n = int($2 / each) } END { print n < 1 ? 1 : n < most ? n : most }' \
        /proc/meminfo
}
jobs=$(jobs_at 3)
unset CXXFLAGS CPPFLAGS LDFLAGS # flags such as -march=native would change the simulation's bits
export NINJA_STATUS='[%f/%t] '
export CCACHE_BASEDIR=$root # so that clones in different folders share results
export CCACHE_SLOPPINESS=pch_defines,time_macros # required by ccache for precompiled headers
export CCACHE_DEPEND=true # the compiler lists the headers: no file is preprocessed before it is compiled
export CCACHE_COMMENTS=true                         # precompiled headers depend on every byte of their files, including comments

# progress LOG: appends its input to LOG and shows only its progress ("[3/80] ..." or "3/80 Test ...").
progress() {
    local line tenth shown=-1
    while IFS= read -r line; do
        printf '%s\n' "$line" >>"$1"
        if [[ ! $line =~ ^\ *\[?([0-9]+)/([0-9]+) || $line == *Re-checking* ]]; then
            continue
        fi
        if [[ -t 1 ]]; then
            printf '\r\033[K  %.100s' "$line"
        else
            tenth=$((BASH_REMATCH[1] * 10 / BASH_REMATCH[2]))
            if ((tenth != shown)); then
                printf '  %.100s\n' "$line"
                shown=$tenth
            fi
        fi
    done
    if [[ -t 1 ]]; then
        printf '\r\033[K'
    fi
}

# configure DIRECTORY [OPTION...]: a folder that was copied or moved here from elsewhere is configured from scratch.
configure() {
    local directory=$1 fresh=()
    shift
    mkdir -p "$directory"
    if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$directory/CMakeCache.txt"; then
        fresh=(--fresh)
    fi
    if ! cmake "${fresh[@]}" -S "$root" -B "$directory" -G Ninja "$@" >"$directory/configure.log" 2>&1; then
        sed -n '/CMake Error/,$p' "$directory/configure.log"
        return 1
    fi
}

# compile DIRECTORY TARGET...: builds, showing progress; on an error shows the compiler's messages.
# Compiler warnings are collected in DIRECTORY/warnings.txt, because ninja does not repeat them.
compile() {
    local directory=$1 log=$1/build.log status=0
    shift
    : >"$log"
    cmake --build "$directory" --parallel "$jobs" --target "$@" 2>&1 | progress "$log" || status=$?
    grep -F 'warning:' "$log" >>"$directory/warnings.txt" || true
    if ((status != 0)); then
        # The errors, without the warnings of other files.
        awk '/^\[[0-9]+\/[0-9]+\]/ { shown = 0 } /^FAILED: |^ninja: error/ { shown = 1 } shown' "$log" | head -n 100 || true
        echo "The build failed; all of it is in $log"
    fi
    return "$status"
}
