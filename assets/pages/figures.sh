#!/bin/sh
# Makes the figures of the pages with the program itself: sh assets/pages/figures.sh   (after a build; run it again when
# a look changes). Two stand side by side, so each has 340 x 212 pixels.
set -e
cd "$(dirname "$0")/../.."
program=build/release/vitrine
figures=assets/pages/figures
figure() {  # figure NAME EXHIBIT OPTIONS...
    name=$1
    exhibit=$2
    shift 2
    $program render "$exhibit" --size 340x212 --samples 8 --out "$figures/$name.png" "$@"
}
figure sdf_morph-box sdf_morph --set showBox=on
figure sdf_morph-plain-steps sdf_morph --set heatMap=evaluations --set heatScale=48 --set relaxation=none --set conePrepass=off
figure sdf_morph-cones sdf_morph --set heatMap=evaluations --set heatScale=48
figure sdf_morph-coarse sdf_morph --set hitTolerance=48 --set conePrepass=off
figure lenticular-card lenticular --preset sixteen-views
figure lenticular-lenses lenticular --set scroll=off --eye=-3.0444,1.114,3.0205 --target=-3.1905,1.084,2.9535 --fov 40
figure lenticular-moire lenticular --preset moire-without-a-filter
figure lenticular-filtered lenticular --preset moire-without-a-filter --set prefilter=on
figure fur-shells fur --set silhouette=none --set clump=0 --set levelOfDetail=off
figure fur-march fur --set clump=0 --set levelOfDetail=off
figure fur-mix fur --set byHand=on --set handY=0 --set handRotation=120deg --set rotationModel="matrix mix"
figure fur-slerp fur --set byHand=on --set handY=0 --set handRotation=120deg
figure crepuscular_rays-mask crepuscular_rays --preset the-mask
figure crepuscular_rays-screen crepuscular_rays --set technique="screen space" --eye=0.9,1.65,-3.5 --target=0,4.3,-12 --fov 55
figure crepuscular_rays-few crepuscular_rays --preset volume --set volumeSteps=4 --set jitter=off
figure crepuscular_rays-volume crepuscular_rays --preset volume
figure sdf_scenes-picture sdf_scenes --alone --preset reference-primitives
figure sdf_scenes-heat sdf_scenes --alone --preset reference-primitives --set heatMap=evaluations --set heatScale=160
figure sdf_scenes-classic sdf_scenes --alone --preset reference-primitives --set shadowMethod=classic --set lampSize=1
figure sdf_scenes-area sdf_scenes --alone --preset reference-primitives --set shadowMethod=area --set lampSize=1
figure noise-value noise --alone --preset wax --set kind=value
figure noise-gradient noise --alone --preset wax
figure noise-once noise --alone --preset evening-clouds --set scatterings=1
figure noise-clouds noise --alone --preset evening-clouds
figure pixel_art-picture pixel_art --alone
figure pixel_art-three pixel_art --alone --set world="test scene" --set view=error --set method="3 tap"
figure pixel_art-nine pixel_art --alone --set world="test scene" --set view=error --set method="9 plus tap"
figure pixel_art-handheld pixel_art --alone --preset handheld-of-1989
figure ice_cream-picture ice_cream
figure ice_cream-wafer ice_cream --set stage="smooth wafer"
figure ice_cream-heat ice_cream --set heatMap=evaluations --set heatScale=64
figure ice_cream-twist ice_cream --set heatMap=evaluations --set heatScale=64 --set upperTwist=12 --set lowerTwist=10
figure paper_lanterns-picture paper_lanterns --alone
figure paper_lanterns-one paper_lanterns --alone --preset one-lantern
figure paper_lanterns-thin paper_lanterns --alone --set lanterns=400 --set spacing=6 --set paperThickness=0.2
figure paper_lanterns-thick paper_lanterns --alone --set lanterns=400 --set spacing=6 --set paperThickness=8
figure your_shader-dunes your_shader --alone --preset dunes
figure your_shader-lantern your_shader --alone --preset gyroid-lantern
figure your_shader-ink your_shader --alone --preset ink
figure your_shader-circle your_shader --alone --preset circle-limit
figure your_shader-few your_shader --alone --preset dunes --set steps=20
figure your_shader-many your_shader --alone --preset dunes --set steps=400
