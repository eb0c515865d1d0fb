#!/bin/sh
# outside_readers_test.sh BUILD: makes files with the program and has them read by programs of other projects. Each that is
# not here is skipped by itself. Exit 77 (skipped) where none of them is.
build=$1
here=$(cd "$(dirname "$0")" && pwd) || exit 2
vitrine=$build/vitrine
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
read_by=0
failed=0

# by PROGRAM: whether it is here.
by() {
    if command -v "$1" >/dev/null 2>&1; then return 0; fi
    echo "skipped: $1 is not here"
    return 1
}

fail() {
    echo "FAILED: $*"
    failed=1
}

# python ARGUMENT...: runs the readers in Python, by the one of the system.
python() {
    PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$here/outside_readers.py" "$@"
    code=$?
    case $code in
        0) read_by=$((read_by + 1)) ;;
        77) ;;
        *) fail "outside_readers.py $*" ;;
    esac
}

# OpenEXR with all channels.
"$vitrine" render sdf_morph --size 48x27 --samples 1 --channels color,depth,normal,albedo,position,object --set baseColor=0.8,0.4,0.2 \
    --out "$folder/a.exr" >/dev/null || exit 1
if by exrheader; then
    exrheader "$folder/a.exr" >"$folder/header" || fail "exrheader cannot read the file"
    for line in "worldToCamera (type m44f)" "worldToNDC (type m44f)" "chromaticities (type chromaticities)" \
        "software (type string)" "vitrine:depth.Z (type string)" "depth.Z, 32-bit floating-point" \
        "CryptoObject00.A, 32-bit floating-point" "position.X, 32-bit floating-point" "albedo.R, 32-bit floating-point" "vitrine:albedo (type string)"; do
        grep -qF "$line" "$folder/header" || fail "exrheader does not find $line"
    done
    read_by=$((read_by + 1))
fi
python exr "$folder/a.exr"

# Standard output.
"$vitrine" render sdf_morph --alone --size 48x27 --samples 1 --out - >"$folder/b.png" || fail "render --out -"
python size "$folder/b.png" 48 27
"$vitrine" render sdf_morph --alone --size 48x27 --samples 1 --out "$folder/c.png" >/dev/null || exit 1
cmp "$folder/b.png" "$folder/c.png" || fail "standard output has other bytes than a file"
"$vitrine" render sdf_morph --alone --size 48x27 --samples 1 --out -.exr >"$folder/b.exr" || fail "render --out -.exr"
if by exrheader; then exrheader "$folder/b.exr" >/dev/null || fail "exrheader cannot read standard output"; fi

# WebP is lossless.
for transparent in "" --transparent; do
    for end in png webp; do
        "$vitrine" render sdf_morph --alone $transparent --size 48x28 --samples 2 --out "$folder/d.$end" >/dev/null ||
            exit 1
    done
    python equal "$folder/d.png" "$folder/d.webp"
done
"$vitrine" render sdf_morph --alone --size 48x28 --samples 1 --out "$folder/d.jpg" >/dev/null || exit 1
python size "$folder/d.jpg" 48 28

# A recording with opacity.
"$vitrine" record sdf_morph --alone --transparent --size 32x32 --samples 1 --fps 4 --seconds 0.5 --out "$folder/e.webm" \
    >/dev/null || exit 1
if by ffprobe; then
    ffprobe -v error -show_entries stream_tags=alpha_mode -of default=nw=1 "$folder/e.webm" | grep -q "=1$" ||
        fail "ffprobe finds no opacity"
    read_by=$((read_by + 1))
fi
"$vitrine" record sdf_morph --alone --size 32x32 --samples 1 --fps 4 --seconds 0.5 --out "$folder/f%02d.exr" >/dev/null ||
    exit 1
if by exrheader; then exrheader "$folder/f02.exr" >/dev/null || fail "exrheader cannot read a frame"; fi

"$vitrine" record sdf_morph --size 48x27 --samples 1 --fps 4 --seconds 0.5 --path turntable --turn 20deg \
    --channels color,depth,position,motion --out "$folder/m%d.exr" >/dev/null || exit 1
python motion "$folder/m1.exr" "$folder/m2.exr"

# Meshes.
cat >"$folder/balls.json" <<'SCENE'
{"format": "vitrine-scene", "version": 1, "name": "Balls <2> & more",
 "materials": {"red": {"model": "phong", "color": [1, 0, 0]}, "green": {"model": "phong", "color": [0, 1, 0]}},
 "root": {"kind": "union", "children": [
   {"kind": "sphere", "radius": 0.2, "material": "red"},
   {"kind": "sphere", "radius": 0.1, "translate": [0, 0.5, 0], "material": "green"}]}}
SCENE
for end in glb ply obj 3mf stl; do
    triangles=$("$vitrine" mesh "$folder/balls.json" --cell 1cm --triangles 2000 --out "$folder/balls.$end" |
        sed -n 's/.*triangles \([0-9]*\),.*/\1/p')
    [ -n "$triangles" ] || exit 1
    [ "$triangles" -le 2000 ] || fail "$end: $triangles triangles instead of 2000"
    if by assimp; then
        assimp info "$folder/balls.$end" >"$folder/info" || fail "assimp cannot read .$end"
        grep -Eq "^Faces: +$triangles\$" "$folder/info" || fail "assimp finds other triangles in .$end"
        read_by=$((read_by + 1))
    fi
done
python 3mf "$folder/balls.3mf" "$triangles"

# A quilt.
"$vitrine" quilt sdf_morph --alone --columns 3 --rows 2 --size 24x32 --samples 1 --out "$folder/g.png" >/dev/null || exit 1
python size "$folder/g_qs3x2a0.75.png" 72 64

# A print as PDF: exact size, boxes, colors, attached settings, and the pixels of the PNG.
for end in png pdf; do
    "$vitrine" print --exhibit sdf_morph --samples 1 --view-size 60x40 --count 4 --lpi 40 --dpi 300 --width-mm 70 \
        --height-mm 50 --bleed-mm 2 --border-mm 6 --crop-marks --registration-marks --pitch-strip --out "$folder/p.$end" \
        >/dev/null || exit 1
done
if by qpdf; then qpdf --check "$folder/p.pdf" >/dev/null || fail "qpdf finds faults"; fi
if by pdfinfo; then
    pdfinfo -box "$folder/p.pdf" >"$folder/boxes" || fail "pdfinfo cannot read the file"
    for line in "MediaBox: *0.00 *0.00 *243.84 *187.20" "BleedBox: *17.04 *17.04 *226.80 *170.16" \
        "TrimBox: *22.7. *22.7. *221.1. *164.[45]."; do
        grep -Eq "$line" "$folder/boxes" || fail "pdfinfo does not find $line"
    done
    pdfdetach -list "$folder/p.pdf" | grep -q "vitrine-print.json" || fail "pdfdetach finds no settings"
    pdfimages -list "$folder/p.pdf" | grep -Eq "image +1016 +780 +icc +3 +8 .* 300 +300 " ||
        fail "pdfimages finds another picture"
    pdfimages -png "$folder/p.pdf" "$folder/from_pdf"
    python equal "$folder/p.png" "$folder/from_pdf-000.png"
    read_by=$((read_by + 1))
fi

# The proof of the PDF is that of the PNG. A PDF of another program is refused.
for end in png pdf; do
    "$vitrine" proof "$folder/p.$end" --angle 5 --out "$folder/proof_$end.png" >/dev/null || fail "proof of a .$end"
done
python equal "$folder/proof_png.png" "$folder/proof_pdf.png"
python pdf "$folder/p.png" "$folder/other.pdf"
if [ -f "$folder/other.pdf" ]; then
    "$vitrine" proof "$folder/other.pdf" --angle 5 --out "$folder/o.png" 2>"$folder/said" && fail "another PDF is read"
    grep -q "it is not a PDF that vitrine print wrote" "$folder/said" || fail "another PDF is refused otherwise"
fi

# The same in tiles that overlap. Read again, they are the print in one piece.
for tile in "" "--tile-mm 25 --tile-overlap-mm 3"; do
    "$vitrine" print --exhibit sdf_morph --samples 1 --view-size 60x40 --count 4 --lpi 40 --dpi 300 --width-mm 70 \
        --height-mm 30 --bleed-mm 2 --border-mm 6 --registration-marks $tile --out "$folder/${tile:+tile}w.tif" \
        >/dev/null 2>&1 || fail "print $tile"
    "$vitrine" proof "$folder/${tile:+tile}w.tif" --angle 0 --out "$folder/${tile:+tile}proof.png" >/dev/null ||
        fail "proof $tile"
done
python tiles "$folder/w.tif" "$folder/tilew-1.tif.json"
python equal "$folder/proof.png" "$folder/tileproof.png"

# Presets, and settings of the whole museum, by their schema.
for presets in "$here"/../../assets/presets/*/; do
    exhibit=$(basename "$presets")
    "$vitrine" preset schema "$exhibit" >"$folder/schema.json" || fail "preset schema $exhibit"
    python schema "$folder/schema.json" "$presets"*.json
done
"$vitrine" preset schema >"$folder/schema.json" || fail "preset schema"
"$vitrine" render sdf_morph --alone --set morph=0.5 --size 8x8 --samples 1 --out "$folder/h.png" >/dev/null || exit 1
python text "$folder/h.png" vitrine:preset >"$folder/h.json"
[ ! -s "$folder/h.json" ] || python schema "$folder/schema.json" "$folder/h.json"

# Findings and other documents of commands, by their schemas. A check of files that are not good ends with 1.
schemas=$here/../../assets/schemas
document() {
    schema=$1
    shift
    "$vitrine" "$@" --json >"$folder/document.json" 2>/dev/null
    code=$?
    [ $code -le 1 ] || fail "$* ends with $code"
    python document "$schemas/$schema.schema.json" "$folder/document.json"
}
echo '{"format": "vitrine-preset", "version": 1, "exhibit": "fur", "name": "a", "values": {"shellCount": "?"}}' >"$folder/bad.json"
printf '{"format": "vitrine-scene", "version": 1, "name": "a",\n "root": {"kind": "cone"}}' >"$folder/scene.json"
printf 'void main() {\n  gl_FragColor = vec4(of);\n}\n' >"$folder/bad.frag"
document findings preset check "$here/../../assets/presets/sdf_morph/"*.json "$folder/h.png" "$folder/bad.json"
document findings lesson check "$here/../../assets/lessons/fur.md" "$folder/bad.json"
document findings scene check "$folder/balls.json" "$folder/scene.json"
document findings shader check "$here/../../assets/shaders/"*.fs "$folder/bad.frag"
document lessons lesson list
document exhibits list
document exhibits list fur
document doctor doctor
document distances compare "$folder/d.png" "$folder/d.jpg" --max 0.001
document distances compare "$folder/c.png" "$folder/c.png" --metric psnr
for morph in 0.2 0.8; do
    "$vitrine" study sdf_morph hitTolerance --alone --size 16x9 --views 1 --runs 1 --values 0.25,1,4 --no-model-error \
        --set morph=$morph --out "$folder/study$morph" >/dev/null || fail "study"
done
document study-differences compare-studies "$folder/study0.2/study.json" "$folder/study0.8/study.json" --cost work \
    --out "$folder/studies"

# Handout and slides of a lesson with formulas, a picture, links, a list and code.
"$vitrine" lesson export sdf_morph --size 32x18 --samples 1 --out "$folder/handout" >/dev/null || fail "lesson export"
python handout "$folder/handout" "$here/../../shaders/lib/sdf.glsl"
# libxml2 does not know the elements of HTML 5, and names each of them.
if by xmllint; then
    for page in handout slides; do
        xmllint --html --noout "$folder/handout/$page.html" 2>&1 | grep error | grep -v ': Tag [a-z]* invalid$' &&
            fail "xmllint cannot read $page.html"
    done
    read_by=$((read_by + 1))
fi

[ $failed -eq 0 ] || exit 1
[ $read_by -gt 0 ] || exit 77
echo "$read_by files were read"
