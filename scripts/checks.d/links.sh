# shellcheck shell=bash
# Checks that the target of every relative link in a Markdown file exists.
set -euo pipefail
status=0
while IFS= read -r file; do
    while IFS= read -r target; do
        if [[ ! -e $(dirname "$file")/$target ]]; then
            echo "$file: there is no $target"
            status=1
        fi
    done < <(grep -oE '\]\([^)#: ]+[)#]' "$file" | sed 's/^](//; s/[)#]$//' | sort -u)
done < <(find . -name '*.md' -not -path './build*' -not -path './.git/*' -not -path './shared/*')
exit "$status"
