#!/bin/sh
# Draws the icon at the sizes that desktops ask for, from vitrine.svg. Needs rsvg-convert (librsvg2-bin).
set -e
cd "$(dirname "$0")"
for size in 16 22 24 32 48 64 128 256 512; do
    rsvg-convert --width "$size" --height "$size" --output "vitrine_$size.png" vitrine.svg
done
