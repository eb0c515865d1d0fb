#!/bin/sh
# Makes every picture that shows the program: the thumbnails of exhibits and shipped presets, the pictures of the
# documents and pages, and those of the window. Run it after a build, when something that they show has changed:
#   sh assets/pictures.sh                            all of them
#   sh assets/pictures.sh thumbnails|documents|window      one part; the window needs xvfb-run and the target show_window
# The test `pictures_of_exhibits` draws the exhibits' thumbnails again and says which are out of date, and whether the
# window's picture shows others than these.
set -e
cd "$(dirname "$0")/.."
export LC_ALL=C
program=build/release/vitrine
pictures=assets/pictures

# picture NAME ARGUMENTS: renders the picture of that name.
picture()
{
    name=$1
    shift
    $program render "$@" --samples "${samples:-16}" --out "$pictures/$name.png"
}

# presets EXHIBIT SIZE PREFIX PRESET...: one picture for each preset, of the exhibit alone.
presets()
{
    exhibit=$1 size=$2 prefix=$3
    shift 3
    for preset in "$@"; do
        picture "$prefix$preset" "$exhibit" --alone --preset "assets/presets/$exhibit/$preset.json" --size "$size"
    done
}

thumbnails()
{
    $program tour --size 192x120 --samples 16 --out assets/thumbnails
    for preset in assets/presets/*/*.json; do
        exhibit=$(basename "$(dirname "$preset")")
        $program render "$exhibit" --preset "$preset" --size 192x120 --samples 16 --out "${preset%.json}.png"
    done
}

documents()
{
    picture hall hall --size 1280x720
    picture golden-hour hall --preset assets/presets/hall/golden-hour.json --set crepuscular_rays.airDensity=0.008 \
        --set crepuscular_rays.densityNoise=0.7 --set crepuscular_rays.densityFalloff=0.12 --set crepuscular_rays.airColor=1,0.9,0.72 \
        --size 1280x720
    picture evening-dust crepuscular_rays --preset assets/presets/crepuscular_rays/evening-dust.json --set hall.sunBy="time of day" \
        --set hall.timeOfDay=16.9 --size 960x540
    for preset in glazed-in-sea-green glass old-gold what-a-ray-costs; do
        picture $preset sdf_morph --preset assets/presets/sdf_morph/$preset.json --size 480x300
    done
    picture lenticular-card lenticular --size 480x300
    picture lenticular-lenses lenticular --eye=-3.0444,1.114,3.0205 --target=-3.1905,1.084,2.9535 --fov 40 --size 480x300
    picture fur fur --preset assets/presets/fur/in-mid-air.json --size 1280x720
    for preset in cat sea-urchin grass dandelion poodle reference teddy carpet as-in-the-reference-video; do
        picture fur-$preset fur --preset assets/presets/fur/$preset.json --size 480x300
    done
    picture ice-cream ice_cream --size 960x540
    presets ice_cream 784x441 ice-cream- reference
    picture noise noise --size 960x540
    presets noise 480x300 noise- evening-clouds noon-clouds storm wax
    picture paper-lanterns paper_lanterns --size 960x540
    presets paper_lanterns 480x300 paper-lanterns- reference dusk full-moon festival storm fog
    picture scenes sdf_scenes --size 960x540
    presets sdf_scenes 480x300 scenes- dahlia rotunda still-life reference-primitives
    picture scenes-primitives sdf_scenes --alone --set scene=primitives.json --set look="physically based" --size 480x300
    picture pixel-art pixel_art --size 960x540
    samples=1
    presets pixel_art 480x270 pixel-art- reference handheld-of-1989 console-of-1983 low-sun
    picture pixel-art-isle pixel_art --alone --size 960x540
    samples=16
    picture your-shader your_shader --size 960x540
    presets your_shader 480x270 your-shader- gyroid-lantern dunes rose-window agate circle-limit ink
}

# The window's list shows the thumbnails: their sum says which ones it showed.
window()
{
    LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb QT_FONT_DPI=96 xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" \
        build/release/tests/show_window $pictures documents
    cat assets/thumbnails/*.png | sha256sum | cut -d ' ' -f 1 > $pictures/window.sha256
}

if [ $# -eq 0 ]; then
    thumbnails
    documents
    window
else
    for part in "$@"; do
        case $part in
        thumbnails | documents | window) $part ;;
        *)
            echo "assets/pictures.sh: \"$part\" is no part: thumbnails, documents or window" >&2
            exit 2
            ;;
        esac
    done
fi
