#!/usr/bin/env bash
# Compiles some sources and headers alone, as in a build without TREMBLER_UNITY: a file that lacks an #include compiles
# where several files are joined, but not on another system that follows the README. All files would take half an hour, so
# each commit checks the files that it changes, at most five of them, and three more: the number of commits determines
# which ones, so that every file has its turn. With ALONE, a list of files, it checks these instead, for example all of a
# folder: ALONE=$(git ls-files 'puzzle/*.[ch]pp') scripts/checks.d/alone.sh. BUILD is the build's folder, if not build.
#
# Only the syntax is checked, with the compiler and the options of the build's target.
set -euo pipefail
build=${BUILD:-build}
if [[ ! -f $build/compile_commands.json ]]; then
    echo "$build/compile_commands.json has not been written: configure the build first"
    exit 77
fi
changed_most=5
turn=3

# These have checks, or options, of their own.
code() {
    grep -E '\.[ch]pp$' | grep -vE '^(tests/compile_fail/|tests/fuzz/engine/|bench/|cmake/)' || true
}

# The command, without its output and input, that compiles a source, alone or joined with others; nothing if none does.
command_of() {
    local file=$PWD/$1 joined
    joined=$(grep -rlF --include='unity_*.cxx' "#include \"$file\"" "$build" | head -n 1)
    [[ -z $joined ]] || file=$PWD/$joined
    awk -v file="\"file\": \"$file\"" '/"command":/ { line = $0 }
        index($0, file) { gsub(/^ *"command": "|",?$| -o .*/, "", line); gsub(/\\"/, "\"", line); gsub(/\\\\/, "\\", line)
                          print line; exit }' "$build/compile_commands.json"
}

# The same for a header: as for a source beside it, or in the nearest folder above that has some.
command_of_header() {
    local folder=$1 source made
    while [[ $folder == */* ]]; do
        folder=${folder%/*}
        while IFS= read -r source; do
            made=$(command_of "$source")
            if [[ -n $made ]]; then
                printf '%s' "$made"
                return
            fi
        done < <(git ls-files "$folder/*.cpp" | head -n 20)
    done
}

if [[ -n ${ALONE:-} ]]; then
    chosen=$(tr -s ' ' '\n' <<<"$ALONE" | code)
elif ! git rev-parse --verify --quiet HEAD >/dev/null; then
    echo "is no checkout of git, so there are no changed files"
    exit 77
else
    changed=$(git diff --name-only --diff-filter=d HEAD | code)
    if [[ -z $changed ]] && git rev-parse --verify --quiet HEAD~1 >/dev/null; then
        changed=$(git diff --name-only --diff-filter=d HEAD~1 HEAD | code)
    fi
    all=$(git ls-files | code)
    total=$(wc -l <<<"$all")
    first=$(($(git rev-list --count HEAD) * turn % total + 1))
    chosen=$(head -n "$changed_most" <<<"$changed")$'\n'$(sed -n "$first,$((first + turn - 1))p" <<<"$all")
fi

wrong=0
while IFS= read -r file; do
    if [[ -z $file || ! -f $file ]]; then
        continue
    fi
    if [[ $file == *.hpp ]]; then # included by an empty source: a header is never compiled as the main file
        command=$(command_of_header "$file")
        input=-
    else
        command=$(command_of "$file")
        input=$PWD/$file
    fi
    if [[ -z $command ]]; then # of a target that this build leaves out
        continue
    fi
    if ! printf '#include "%s"\n' "$file" | bash -c "$command -fsyntax-only -Werror -x c++ $input"; then
        echo "$file does not compile alone"
        wrong=1
    fi
done < <(sort -u <<<"$chosen")
exit "$wrong"
