#!/bin/sh
# Makes the thumbnails of exhibits and shipped presets, and the pictures of the READMEs, with the program
# itself: sh assets/thumbnails.sh   (after a build; run it again when a look changes)
set -e
cd "$(dirname "$0")/.."
program=build/release/vitrine
mkdir -p assets/thumbnails assets/pictures
for exhibit in hall sdf_morph lenticular fur crepuscular_rays sdf_scenes noise pixel_art ice_cream paper_lanterns; do
    $program render $exhibit --size 192x120 --samples 16 --out assets/thumbnails/$exhibit.png
    for preset in assets/presets/$exhibit/*.json; do
        $program render $exhibit --preset "$preset" --size 192x120 --samples 16 --out "${preset%.json}.png"
    done
done
$program render hall --size 1280x720 --samples 16 --out assets/pictures/hall.png
$program render hall --preset assets/presets/hall/golden-hour.json --set crepuscular_rays.airDensity=0.022 --set crepuscular_rays.densityNoise=0.7 \
    --set crepuscular_rays.densityFalloff=0.12 --set crepuscular_rays.airColor=1,0.9,0.72 --size 1280x720 --samples 16 --out assets/pictures/golden-hour.png
$program render crepuscular_rays --preset assets/presets/crepuscular_rays/evening-dust.json --set hall.sunBy="time of day" --set hall.timeOfDay=16.9 \
    --size 960x540 --samples 16 --out assets/pictures/evening-dust.png
for look in glazed-in-sea-green glass old-gold what-a-ray-costs; do
    $program render sdf_morph --preset assets/presets/sdf_morph/$look.json --size 480x300 --samples 16 --out assets/pictures/$look.png
done
$program render lenticular --size 480x300 --samples 16 --out assets/pictures/lenticular-card.png
$program render lenticular --eye=-3.0444,1.114,3.0205 --target=-3.1905,1.084,2.9535 --fov 40 --size 480x300 --samples 16 --out assets/pictures/lenticular-lenses.png
$program render fur --preset assets/presets/fur/in-mid-air.json --size 1280x720 --samples 16 --out assets/pictures/fur.png
for look in cat sea-urchin grass dandelion poodle reference teddy carpet as-in-the-reference-video; do
    $program render fur --preset assets/presets/fur/$look.json --size 480x300 --samples 16 --out assets/pictures/fur-$look.png
done
$program render ice_cream --size 960x540 --samples 16 --out assets/pictures/ice-cream.png
$program render ice_cream --alone --preset assets/presets/ice_cream/reference.json --size 784x441 --samples 16 --out assets/pictures/ice-cream-reference.png
for look in evening-clouds noon-clouds above-the-clouds storm wax asteroids; do
    $program render noise --alone --preset assets/presets/noise/$look.json --size 480x300 --samples 16 --out assets/pictures/noise-$look.png
done
$program render noise --size 960x540 --samples 16 --out assets/pictures/noise.png
$program render paper_lanterns --size 960x540 --samples 16 --out assets/pictures/paper-lanterns.png
for look in reference dusk full-moon festival storm fog dawn; do
    $program render paper_lanterns --alone --preset assets/presets/paper_lanterns/$look.json --size 480x300 --samples 16 --out assets/pictures/paper-lanterns-$look.png
done
for look in dahlia rotunda still-life reference-primitives primitives; do
    $program render sdf_scenes --alone --preset assets/presets/sdf_scenes/$look.json --size 480x300 --samples 16 --out assets/pictures/scenes-$look.png
done
$program render sdf_scenes --size 960x540 --samples 16 --out assets/pictures/scenes.png
$program render pixel_art --size 960x540 --samples 16 --out assets/pictures/pixel-art.png
for look in reference handheld-of-1989 console-of-1983 low-sun; do
    $program render pixel_art --alone --preset assets/presets/pixel_art/$look.json --size 480x270 --samples 1 --out assets/pictures/pixel-art-$look.png
done
$program render pixel_art --alone --size 960x540 --samples 1 --out assets/pictures/pixel-art-isle.png
