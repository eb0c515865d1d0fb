#!/bin/sh
# sh tests/exhibits/your_shader/corpus.sh FOLDER [STEP]   counts how many ISF files of a folder load and draw without error
# STEP: draws every STEP-th file of the sorted list, beginning with the second; 1: all. Needs build/release/vitrine.
# Prints a line for each file that fails, and the counts.
cd "$(dirname "$0")/../../.." || exit 2
folder=$1
step=${2:-1}
[ -d "$folder" ] || { echo "corpus.sh: name a folder of .fs files" >&2; exit 2; }
picture=$(mktemp -d) || exit 2
trap 'rm -rf "$picture"' EXIT
number=0 drawn=0 tried=0
find "$folder" -name '*.fs' | LC_ALL=C sort > "$picture/list"
while IFS= read -r file; do
    number=$((number + 1))
    [ $((number % step)) -eq 0 ] || continue
    tried=$((tried + 1))
    if problem=$(timeout 120 build/release/vitrine render your_shader --alone --set file="$file" --set moment=0.05 --samples 1 \
        --size 64x48 --out "$picture/own.png" 2>&1 < /dev/null); then
        drawn=$((drawn + 1))
    else
        printf '%s: %s\n' "$file" "$problem"
    fi
done < "$picture/list"
echo "$drawn of $tried files were drawn"
[ "$drawn" -eq "$tried" ]
