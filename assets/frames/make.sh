#!/bin/sh
# Makes the two sets of views on the card in the hall, with the program itself: sh assets/frames/make.sh
# (after a build; takes a minute or two without a GPU; run it again when a look changes)
set -e
cd "$(dirname "$0")/../.."
program=build/release/vitrine
# Cards of the card's own shape, on a sheet with room for 16 views.
card="--count 16 --lpi 40 --dpi 720 --width-mm 600 --height-mm 400"
picture="--view-size 480x320 --samples ${SAMPLES:-25}"

# A mug of orange glaze in a dark studio, turning its handle to the front.
rm -f assets/frames/turning_mug/view_*
$program print --exhibit sdf_morph --preset assets/presets/sdf_morph/porcelain-mug.json --alone \
    --set baseColor=0.42,0.045,0.012 --set roughness=0.1 --set hall.exposure=-0.35 \
    --eye=-1.1,0.53,-1.2 --target 0,-0.09,-0.035 --fov 35 \
    --rotate 0,-150,0 --turn 110 \
    $card $picture --save-views assets/frames/turning_mug

# A ring of blue glass before the window, melting into a mug as it turns.
rm -f assets/frames/melting_torus/view_*
$program print --exhibit sdf_morph --preset assets/presets/sdf_morph/glass.json \
    --set baseColor=0.4,0.68,0.96 --sweep morph=0.02..0.88 --turn 110 \
    --eye=0.3,1.72,1.5 --target 0,1.44,0 --fov 36 \
    $card $picture --save-views assets/frames/melting_torus
