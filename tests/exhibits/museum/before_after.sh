#!/bin/sh
# sh tests/exhibits/museum/before_after.sh BEFORE AFTER FOLDER [SIZE [SAMPLES]]   pictures of two builds side by side, as one page
# BEFORE, AFTER: the programs, each in its own checkout, whose assets it reads. SIZE: of each picture; 640x360 if omitted.
# SAMPLES: per pixel; 16 if omitted.
# Writes FOLDER/index.html: every exhibit's first view and the hall by day, at dusk and by night, the difference as the
# program measures it, and the picture that each is judged against.
set -e
[ $# -ge 3 ] || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
before=$1 after=$2 folder=$3 size=${4:-640x360} samples=${5:-16}
mkdir -p "$folder"
export LC_ALL=C

# The reference of each subject, by its file of `vitrine tour`.
reference()
{
    case $1 in
        hall*) echo "a museum hall of architectural visualization in Unreal Engine 5" ;;
        sdf_morph) echo "a product shot of chrome in Eevee" ;;
        lenticular) echo "photographs of lenticular prints" ;;
        fur) echo "fur of XGen, shaded after Marschner" ;;
        crepuscular_rays) echo "volumetric light of Frostbite; photographs of sunbeams in churches" ;;
        sdf_scenes) echo "Inigo Quilez: Snail, Selfie Girl" ;;
        noise) echo "Seascape by TDM; the clouds of Nubis" ;;
        pixel_art) echo "pixel art from 3D by t3ssel8r" ;;
        ice_cream) echo "subsurface scattering in Blender's Cycles" ;;
        paper_lanterns) echo "photographs of Toro Nagashi" ;;
        your_shader) echo "Inigo Quilez: shaders of one page on Shadertoy" ;;
        *) echo "none" ;;
    esac
}

for side in before after; do
    program=$before
    [ "$side" = before ] || program=$after
    "$program" tour --size "$size" --samples "$samples" --out "$folder/$side" >&2
    for hour in 12 17.6 21; do
        "$program" render hall --set "sunBy=time of day" --set timeOfDay=$hour --size "$size" --samples "$samples" \
            --out "$folder/$side/hall-at-$hour.png" >&2
    done
done
{
    echo '<!doctype html><meta charset="utf-8"><title>Before and after</title>'
    echo '<style>body{font:16px sans-serif;background:#1f1f1e;color:#d8d4cc}img{width:49%}</style>'
    printf '<h1>Before and after</h1><p>Left: %s. Right: %s. %s pixels, %s samples.</p>\n' \
        "$("$before" --version | head -1)" "$("$after" --version | head -1)" "$size" "$samples"
    for picture in "$folder"/after/*.png; do
        name=$(basename "$picture" .png)
        printf '<h2>%s</h2><p>Reference: %s. ' "$name" "$(reference "$name")"
        if [ -f "$folder/before/$name.png" ]; then
            "$after" compare "$folder/before/$name.png" "$picture" --metric flip |
                awk 'NR == 1 { if ($2 > 0) printf "Mean difference (FLIP): %.5f.</p>", $2; else printf "No difference.</p>" }'
            printf '<img src="before/%s.png" alt="before">' "$name"
        else
            printf 'New.</p>'
        fi
        printf '<img src="after/%s.png" alt="after">\n' "$name"
    done
} > "$folder/index.html"
echo "$folder/index.html"
