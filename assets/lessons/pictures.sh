#!/bin/sh
# Makes the pictures of the lessons with the program itself: sh assets/lessons/pictures.sh   (after a build; run it again when
# a look changes). A lesson shows pictures of its own folder only, so that each language has a copy.
set -e
cd "$(dirname "$0")/../.."
program=build/release/vitrine
lessons=assets/lessons
$program render sdf_morph --size 240x150 --samples 16 --out "$lessons/sdf_morph-exact.png"
cp "$lessons/sdf_morph-exact.png" "$lessons/de/sdf_morph-exact.png"
