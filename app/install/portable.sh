#!/bin/sh
# Makes a folder, and its archive, that run on any x86-64 Linux with a graphics driver and a C library that is not older than
# this system's:
#   sh app/install/portable.sh BUILD FOLDER ARCHIVE [PROGRAM...]     programs of the build tree to lie beside vitrine
# FOLDER/vitrine starts the program. ARCHIVE ends in .tar.xz; "-" makes none. A FOLDER that this script made is replaced.
# Needs patchelf, optipng and the compiler.
#
# lib             Libraries of the program. A library of a file format or protocol that Vitrine does not use is replaced by a
#                 placeholder of the same name, whose functions return 0: OpenImageIO, FFmpeg, ICU and GnuTLS, which computes
#                 qpdf's checksums, name 200 MB of libraries.
# lib/fallback    Libraries that the graphics driver or the display may use as well. Each is used only where the system has none
#                 or an older one: two versions in one process would not agree.
# Left out are the C library and the graphics driver: they belong to the machine.
set -e
build=$(cd "$1" && pwd)
folder=$2
archive=$3
shift 3
if [ -e "$folder" ] && [ ! -e "$folder/bin/qt.conf" ]; then
    echo "portable.sh: $folder is there and is no portable folder; name another one." >&2
    exit 2
fi
for tool in patchelf optipng; do
    command -v $tool >/dev/null 2>&1 || { echo "portable.sh: $tool is missing; install the package of that name." >&2; exit 2; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

machine='^(ld-linux-x86-64|lib(c|m|dl|rt|pthread|resolv|util|GL|GLX|EGL|GLdispatch|GLESv2|gbm|vulkan|cuda[^.]*|nvidia[^.]*))\.so'
shared='^lib(OpenGL|stdc\+\+|gcc_s|z|zstd|lzma|bz2|expat|drm|X11|X11-xcb|xcb|xcb-[a-z0-9]+|Xau|Xdmcp|Xext|Xfixes|Xrender|bsd|md|wayland-[a-z]+|ffi|fontconfig|freetype|brotli[a-z]+|harfbuzz|graphite2|glib-2|pcre2-8|dbus-1|systemd|gcrypt|gpg-error|cap|lz4|uuid|udev)[.0-9-]*\.so'
# Libraries whose dependencies become placeholders, and the dependencies that do not.
greedy='^(lib(OpenImageIO|OpenImageIO_Util|av[a-z]+|sw[a-z]+|tiff|SDL2-2\.0|icuuc|icui18n|gnutls)\.so)'
wanted='^lib(OpenImageIO_Util|av(codec|filter|format|util)|sw(scale|resample)|OpenEXR|OpenEXRCore|Iex|IlmThread|Imath|tbb|boost_thread|tiff|webp|webpmux|webpdemux|jpeg|png16|deflate|jbig|Lerc|x264|openh264|vpx|fmt|icuuc|icui18n|nettle|hogweed|gmp|tasn1)[.0-9_d-]*\.so'

rm -rf "$folder"
cmake --install "$build" --prefix "$folder" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
folder=$(cd "$folder" && pwd)
mv "$folder/share/doc/vitrine/copyright" "$folder/COPYRIGHT"
rm -rf "$folder/share/doc" "$folder/share/man" "$folder/share/lintian" "$folder/share/bash-completion" "$folder/share/zsh" "$folder/lib/python3"
for program in "$@"; do cp "$program" "$folder/bin/"; done
mkdir -p "$folder/lib/fallback" "$folder/lib/qt/translations"
plugins=$(qtpaths6 --query QT_INSTALL_PLUGINS 2>/dev/null || qmake6 -query QT_INSTALL_PLUGINS)
for plugin in platforms/libqxcb platforms/libqoffscreen platforms/libqwayland-generic platforms/libqwayland-egl xcbglintegrations/libqxcb-glx-integration \
    xcbglintegrations/libqxcb-egl-integration imageformats/libqsvg imageformats/libqjpeg iconengines/libqsvgicon \
    platforminputcontexts/libcomposeplatforminputcontextplugin; do
    [ -e "$plugins/$plugin.so" ] || continue
    mkdir -p "$folder/lib/qt/plugins/${plugin%/*}"
    cp "$plugins/$plugin.so" "$folder/lib/qt/plugins/$plugin.so"
done
translations=$(qtpaths6 --query QT_INSTALL_TRANSLATIONS 2>/dev/null || qmake6 -query QT_INSTALL_TRANSLATIONS)
cp "$translations"/qtbase_de.qm "$folder/lib/qt/translations/" 2>/dev/null || true
printf '[Paths]\nPrefix = ../lib/qt\nPlugins = plugins\nTranslations = translations\n' >"$folder/bin/qt.conf"
ours() { find "$folder/bin" "$folder/lib/vitrine" "$folder/lib/qt" -type f \( -name '*.so' -o -perm -u+x ! -name '*.conf' \); }
needed() { readelf -d "$1" 2>/dev/null | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'; }

# Every library that anything here needs, with its path: "name path" in found, the names of placeholders in dropped.
ours | while read -r file; do ldd "$file"; done | sed -n 's/^[[:space:]]*\([^ ]*\) => \(\/[^ ]*\).*/\1 \2/p' | sort -u >"$work/paths"
path_of() { sed -n "s|^$1 ||p" "$work/paths" | head -n 1; }
: >"$work/found"
: >"$work/dropped"
ours | sort >"$work/queue"
while [ -s "$work/queue" ]; do
    : >"$work/next"
    while read -r file; do
        for name in $(needed "$file"); do
            if printf '%s\n' "$name" | grep -qE "$machine"; then continue; fi
            if printf '%s\n' "${file##*/}" | grep -qE "$greedy" && ! printf '%s\n' "$name" | grep -qE "$wanted" &&
                ! printf '%s\n' "$name" | grep -qE "$shared"; then
                echo "$name" >>"$work/dropped"
            elif ! grep -q "^$name " "$work/found"; then
                path=$(path_of "$name")
                [ -n "$path" ] || { echo "portable.sh: $file needs $name, which is not on this system." >&2; exit 1; }
                echo "$name $path" >>"$work/found"
                echo "$path" >>"$work/next"
            fi
        done
    done <"$work/queue"
    mv "$work/next" "$work/queue"
done
# A library that something else needs as well is no placeholder.
sort -u "$work/dropped" | while read -r name; do grep -q "^$name " "$work/found" || echo "$name"; done >"$work/placeholders"

while read -r name path; do
    if printf '%s\n' "$name" | grep -qE "$shared"; then
        mkdir "$folder/lib/fallback/$name"
        cp -L "$path" "$folder/lib/fallback/$name/$name"
        basename "$(readlink -f "$path")" >"$folder/lib/fallback/$name/version"
    else
        cp -L "$path" "$folder/lib/$name"
    fi
done <"$work/found"

# Placeholders define exactly the symbols that the libraries here need of them and find nowhere else.
symbols() { readelf --dyn-syms -W "$1" 2>/dev/null | awk 'NR > 3 && $8 != "" { print ($7 == "UND" ? "U" : $7 == "ABS" ? "A" : "D"), $4, $3, $8 }'; }
{ ours; find "$folder/lib" -maxdepth 1 -name '*.so*'; find "$folder/lib/fallback" -name '*.so*'; } | while read -r file; do symbols "$file"; done |
    sed 's/@.*//' | sort -u >"$work/symbols"
awk '$1 == "D" { print $4 }' "$work/symbols" | sort -u >"$work/defined"
awk '$1 == "U" { print $4 }' "$work/symbols" | sort -u | comm -23 - "$work/defined" >"$work/open"
while read -r name; do
    path=$(path_of "$name")
    {
        symbols "$path"
        readelf -V -W "$path" | sed -n '/gnu.version_d/,/^$/s/.*Flags: [a-z].*Name: /V /p'
    } | awk -v open="$work/open" '
        BEGIN { while ((getline line < open) > 0) wanted[line] = 1
                print ".section .rodata\nempty: .zero 64" }
        $1 == "V" { versions[$2] = versions[$2] }
        # "name@VERSION" is an older version of a symbol beside "name@@VERSION".
        $1 == "D" { symbol = $4; version = ""; label = symbol
            if ((at = index($4, "@")) > 0) { symbol = substr($4, 1, at - 1); version = substr($4, at) }
            if (!(symbol in wanted)) next
            label = symbol
            if (version ~ /^@[^@]/) { label = "older" ++count; print ".symver " label "," symbol version }
            else if (version != "") { gsub(/@/, "", version); versions[version] = versions[version] " \"" symbol "\";" }
            if ($2 == "TLS") print ".section .tbss,\"awT\",@nobits\n.globl " label "\n.type " label ",@object\n" label ": .zero " $3
            else if ($2 == "OBJECT") print ".bss\n.balign 32\n.globl " label "\n.type " label ",@object\n.size " label "," $3 "\n" label ": .zero " ($3 < 65536 ? $3 : 64)
            else print ".text\n.globl " label "\n.type " label ",@function\n" label ": " \
                (tolower(symbol) ~ /version/ ? "lea empty(%rip), %rax" : "xor %eax, %eax") "\nret"
        }
        END { for (version in versions) print version " {" (versions[version] == "" ? "" : " global:" versions[version]) " };" > "'"$work"'/map"; print ".section .note.GNU-stack" }' >"$work/placeholder.s"
    # shellcheck disable=SC2046
    cc -shared -nostdlib -o "$folder/lib/$name" -Wl,-soname,"$name" $([ ! -e "$work/map" ] || echo "-Wl,--version-script,$work/map") "$work/placeholder.s"
    rm -f "$work/map"
done <"$work/placeholders"

# An RPATH of the program holds for everything that it opens later, too; RUNPATH would not.
find "$folder/bin" "$folder/lib" -type f \( -name '*.so*' -o -perm -u+x \) ! -name '*.conf' -exec strip --strip-unneeded {} + 2>/dev/null || true
for file in "$folder"/bin/* "$folder/lib/vitrine/vitrine_shader_compiler" "$folder"/lib/vitrine/modules/*.so "$folder"/lib/qt/plugins/*/*.so; do
    case $file in *.conf) continue ;; esac
    patchelf --force-rpath --set-rpath "\$ORIGIN/$(realpath --relative-to="$(dirname "$file")" "$folder/lib")" "$file"
done
for file in "$folder"/lib/*.so* "$folder"/lib/fallback/*/*.so*; do patchelf --remove-rpath "$file"; done
cp "$(dirname "$0")/portable_start.sh" "$folder/vitrine"
cp "$(dirname "$0")/portable_benchmarks.sh" "$folder/run-benchmarks"
[ -e "$folder/bin/benchmarks" ] || rm "$folder/run-benchmarks"
cp "$(dirname "$0")/portable.txt" "$folder/README.txt"
chmod 755 "$folder/vitrine" "$folder"/run-* 2>/dev/null || true
# The program writes PNG fast. These files stay closed at the start, so that smaller ones, with the same pixels, delay nothing.
find "$folder/share/vitrine/pages" "$folder/share/vitrine/presets" -name '*.png' -exec optipng -quiet -o1 {} +
[ "$archive" = - ] || tar --create --sort=name --directory "$(dirname "$folder")" --owner=0 --group=0 "$(basename "$folder")" |
    xz --x86 --lzma2=preset=9e,dict=192MiB >"$archive"
du -s --apparent-size --block-size=1MB "$folder" $([ "$archive" = - ] || echo "$archive") | sed 's/\t/ MB /' >&2
