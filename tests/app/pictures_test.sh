#!/bin/sh
# Whether the thumbnails of exhibits are of today's program, and whether the window's picture in README.md shows these
# thumbnails: sh pictures_test.sh BUILD
export LC_ALL=C
program=$1/vitrine
cd "$(dirname "$0")/../.." || exit 2
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
failed=0

# same COMMITTED DRAWN: the root mean square difference is at most 2.5 codes of 255: drivers differ by
# less, and what visitors notice is more.
same()
{
    "$program" compare "$1" "$2" --max 0.01 > "$made/said" 2>&1 && return
    echo "$1 is not of today's program: $(cat "$made/said"). Run: sh assets/pictures.sh" >&2
    failed=1
}

"$program" tour --size 192x120 --samples 16 --out "$made" || exit 1
count=0
for thumbnail in assets/thumbnails/*.png; do
    count=$((count + 1))
    same "$thumbnail" "$made/$(basename "$thumbnail")"
done
[ $count -ge 10 ] || { echo "only $count exhibits were compared" >&2; failed=1; }
if [ "$(cat assets/thumbnails/*.png | sha256sum | cut -d ' ' -f 1)" != "$(cat assets/pictures/window.sha256)" ]; then
    echo "assets/pictures/window.png shows other thumbnails. Run: sh assets/pictures.sh window" >&2
    failed=1
fi
exit $failed
