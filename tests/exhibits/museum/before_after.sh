#!/bin/sh
# sh tests/exhibits/museum/before_after.sh BEFORE AFTER FOLDER [SIZE [SAMPLES]]   pictures of two builds side by side, as one page
# BEFORE, AFTER: the programs, each in its own checkout, whose assets it reads. SIZE: of each picture; 640x360 if omitted.
# SAMPLES: per pixel; 16 if omitted.
# Writes FOLDER/index.html: every exhibit's first view and the hall by day, at dusk and by night, the difference as the
# program measures it, and the picture that each is judged against.
set -e
[ $# -ge 3 ] || { sed -n '2,6s/^# //p' "$0" >&2; exit 2; }
before=$1 after=$2 folder=$3 size=${4:-640x360} samples=${5:-16}
hours="12 17.6 21"
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

# File names and titles of all pictures, in the order of the page: the hall at its hours follows the hall.
subjects()
{
    # shellcheck disable=SC2086
    "$after" list --json | python3 -c '
import json, sys
for exhibit in json.load(sys.stdin)["exhibits"]:
    print(exhibit["name"], exhibit["title"])
    for hour in sys.argv[1:] if exhibit["name"] == "hall" else []:
        print(f"hall-at-{hour}", exhibit["title"], f"at {int(float(hour))}:{round(float(hour) % 1 * 60):02}")
' $hours
}

# version PROGRAM: its name and commit.
version() { "$1" --version | head -1; }

# picture SIDE NAME: that picture with a caption, as a link to its file.
picture()
{
    if [ -f "$folder/$1/$2.png" ]; then
        printf '<figure><a href="%s/%s.png"><img src="%s/%s.png" alt="%s, %s" width="%s" height="%s"></a>' \
            "$1" "$2" "$1" "$2" "$2" "$1" "${size%x*}" "${size#*x}"
    else
        printf '<figure><p class="none">Not in this build.</p>'
    fi
    printf '<figcaption>%s</figcaption></figure>\n' "$1"
}

# difference NAME: a sentence about the two pictures of that name.
difference()
{
    [ -f "$folder/before/$1.png" ] && [ -f "$folder/after/$1.png" ] || return 0
    "$after" compare "$folder/before/$1.png" "$folder/after/$1.png" --metric flip |
        awk 'NR == 1 { if ($2 > 0) printf "Mean difference (FLIP): %.5f.", $2; else printf "No difference." }'
}

for side in before after; do
    program=$before
    [ "$side" = before ] || program=$after
    "$program" tour --size "$size" --samples "$samples" --out "$folder/$side" >&2
    for hour in $hours; do
        "$program" render hall --set "sunBy=time of day" --set timeOfDay="$hour" --size "$size" --samples "$samples" \
            --out "$folder/$side/hall-at-$hour.png" >&2
    done
done
subjects > "$folder/subjects.txt"
{
    cat << 'EOF'
<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Before and after</title>
<style>
body { margin: 24px; background: #1f1f1e; color: #d8d4cc; font: 16px/1.5 sans-serif; }
a { color: #d9a05b; }
nav a { display: inline-block; margin-right: 16px; }
h2 { margin: 40px 0 0; }
p { margin: 4px 0 8px; }
.pair { display: grid; grid-template-columns: repeat(2, minmax(0, max-content)); gap: 8px; }
@media (max-width: 800px) { .pair { grid-template-columns: minmax(0, max-content); } }
figure { margin: 0; }
img { display: block; max-width: 100%; height: auto; }
figcaption, code { color: #9a958c; font-size: 14px; }
.none { border: 1px dashed #9a958c; padding: 16px; }
</style>
EOF
    printf '<h1>Before and after</h1>\n<p>Before: %s. After: %s. %s pixels, samples per pixel: %s. ' \
        "$(version "$before")" "$(version "$after")" "$size" "$samples"
    printf 'A click on a picture opens it in full size.</p>\n<nav>'
    while read -r name title; do
        printf '<a href="#%s">%s</a> ' "$name" "$title"
    done < "$folder/subjects.txt"
    printf '</nav>\n'
    while read -r name title; do
        printf '<h2 id="%s">%s</h2>\n<p>Reference: %s. %s <code>%s</code></p>\n<div class="pair">\n' \
            "$name" "$title" "$(reference "$name")" "$(difference "$name")" "$name.png"
        picture before "$name"
        picture after "$name"
        printf '</div>\n'
    done < "$folder/subjects.txt"
} > "$folder/index.html"
rm "$folder/subjects.txt"
echo "$folder/index.html"
