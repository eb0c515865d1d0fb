#!/bin/sh
# sprite_readers_test.sh BUILD: makes sprite sheets with both forms of description and reads them by the parsers of Phaser
# and Pixi. npm fetches these once, into BUILD. Exit 77 (skipped) where they cannot be had.
build=$1
modules=$build/sprite_readers
here=$(dirname "$0")
if ! command -v node >/dev/null 2>&1 || ! command -v npm >/dev/null 2>&1; then
    echo "skipped: node and npm are not here"
    exit 77
fi
if ! [ -f "$modules/node_modules/pixi.js/package.json" ] || ! [ -f "$modules/node_modules/phaser/package.json" ]; then
    mkdir -p "$modules"
    if ! timeout 200 npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$modules" phaser@3.90.0 \
        pixi.js@8.6.6 >/dev/null 2>&1; then
        echo "skipped: npm cannot fetch phaser@3.90.0 and pixi.js@8.6.6"
        exit 77
    fi
fi
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
for trim in "" --trim; do
    for form in array hash; do
        mkdir -p "$folder/$form"
        "$build/vitrine" sprite --directions 8 --frames 3 --size 24x32 --direction-names compass --form "$form" $trim \
            --out "$folder/$form/hero.png" || exit 1
    done
    node "$here/sprite_readers.cjs" "$modules/node_modules" "$folder/array/hero.json" "$folder/hash/hero.json" || exit 1
done
