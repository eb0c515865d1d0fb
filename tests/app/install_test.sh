#!/bin/sh
# install_test.sh BUILD: installs a built tree into an empty folder and looks at what lies there with the tools of the
# desktop, as far as they are here; then makes the Debian package and asks lintian. Exit 77: none of the tools is here.
set -e
build=$(cd "$1" && pwd)
source=$(cd "$(dirname "$0")/../.." && pwd)
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
asked=0

fail() {
    echo "install_test: $*" >&2
    exit 1
}
# has TOOL: whether it is here; says so where it is not.
has() {
    if command -v "$1" >/dev/null 2>&1; then
        asked=$((asked + 1))
        return 0
    fi
    echo "not asked, because it is not installed: $1"
    return 1
}

cmake --install "$build" --prefix "$root/usr" >"$root/log" || { cat "$root/log"; fail "cmake --install failed"; }
share=$root/usr/share
for file in bin/vitrine lib/vitrine/modules/libvitrine_oiio.so lib/vitrine/modules/libvitrine_video.so lib/vitrine/modules/libvitrine_draco.so lib/vitrine/modules/libvitrine_gamepad.so lib/vitrine/modules/libvitrine_controllers.so lib/vitrine/modules/libvitrine_editor.so share/vitrine/presets/fur/cat.json \
    share/vitrine/lessons/fur.md share/vitrine/lessons/de/fur.md share/vitrine/pages/de/fur.html share/vitrine/pages/figures/fur-march.png share/vitrine/pages/page.css share/vitrine/pages/figures/penumbra.svg \
    lib/python3/dist-packages/vitrine/__init__.py share/applications/org.vitrine.Vitrine.desktop share/icons/hicolor/48x48/apps/org.vitrine.Vitrine.png share/man/man1/vitrine.1.gz; do
    [ -e "$root/usr/$file" ] || fail "$file was not installed"
done
if find "$root/usr" -name '*.py' -o -name '*.sh' -o -name '*.h' -o -name '*.a' | grep -v -e /share/doc/ -e /lib/python3/dist-packages/vitrine/; then fail "these serve only who builds it"; fi

# The manual has all that it links to, but for what contributors read in the source tree; and the font its license, whose
# words stand in the copyright, too.
for document in README.md ui/README.md app/README.md app/serve/README.md exhibits/README.md exhibits/printing/README.md \
    exhibits/study/README.md render/README.md; do
    folder=$share/doc/vitrine/$(dirname "$document")
    for link in $(sed '/^```/,/^```/d' "$share/doc/vitrine/$document" | grep -o '](\([^):#]*[):#]\)' | sed 's/^](//; s/.$//'); do
        case $link in '' | http* | *.github/*) continue ;; esac
        [ -e "$folder/$link" ] || fail "the manual's $document links to $link, which was not installed"
    done
done
for file in "$share/vitrine/fonts/OFL.txt" "$share/doc/vitrine/copyright"; do
    for words in 'Georg A. Duffner' 'SIL OPEN FONT LICENSE Version 1.1' 'Neither the Font Software nor any of its individual' 'THE FONT SOFTWARE IS PROVIDED'; do
        grep -q "$words" "$file" || fail "$file lacks \"$words\""
    done
done

# It runs where it lies, from its own assets and modules.
cd "$root"
mv "$root/usr" "$root/elsewhere"
"$root/elsewhere/bin/vitrine" render fur --size 32x18 --samples 1 --alone --out "$root/picture.tif"
[ -s "$root/picture.tif" ] || fail "the installed program drew nothing"
"$root/elsewhere/bin/vitrine" doctor >"$root/doctor"
grep -q "$root/elsewhere/share/vitrine" "$root/doctor" || fail "it has its assets from somewhere else"
grep -q "manual *$root/elsewhere/share/doc/vitrine/README.md" "$root/doctor" || fail "it does not find its manual"
mv "$root/elsewhere" "$root/usr"


# Texts of the desktop file are translated into German.
for key in 'GenericName[de]=' 'Comment[de]=' 'Keywords[de]='; do
    grep -qF "$key" "$share/applications/org.vitrine.Vitrine.desktop" || fail "the desktop file lacks $key"
done
translated() {  # translated FILE TAG: as many of these elements in German as without a language, besides the releases.
    sed '/<releases>/,/<\/releases>/d' "$1" >"$root/texts"
    english=$(grep -c "<$2>" "$root/texts") && german=$(grep -c "<$2 xml:lang=\"de\">" "$root/texts") && [ "$english" = "$german" ] ||
        fail "$1: not every <$2> has its German"
}
for tag in summary developer_name p li; do translated "$share/metainfo/org.vitrine.Vitrine.metainfo.xml" "$tag"; done
translated "$share/mime/packages/org.vitrine.Vitrine.xml" comment

# The releases are those of the change log, newest first, and the first is the version of the program.
logged=$(sed -n 's/^vitrine (\(.*\)) .*/\1/p' "$source/app/install/changelog")
released=$(sed -n 's/.*<release version="\([^"]*\)".*/\1/p' "$share/metainfo/org.vitrine.Vitrine.metainfo.xml")
[ "$logged" = "$released" ] || fail "the change log has the releases $logged, and the AppStream file $released"
version=$("$root/usr/bin/vitrine" --version | sed 's/^vitrine //; s/+.*//')
[ "$(echo "$logged" | head -n 1)" = "$version" ] || fail "the change log begins with $logged, and the program is $version"

# With an address of published pictures, the AppStream file names screenshots, each of which exists.
cmake -DVITRINE_PICTURES_URL=https://example.org/pictures -DOUT="$root/published.metainfo.xml" -P "$source/app/install/metainfo.cmake"
shown=$(sed -n 's|.*<image type="source">https://example.org/pictures/\(.*\)</image>|\1|p' "$root/published.metainfo.xml")
[ "$(echo "$shown" | wc -l)" -ge 3 ] || fail "the AppStream file names too few screenshots: $shown"
for picture in $shown; do [ -s "$source/assets/pictures/$picture" ] || fail "there is no picture $picture"; done
translated "$root/published.metainfo.xml" caption

if has desktop-file-validate; then
    desktop-file-validate "$share/applications/org.vitrine.Vitrine.desktop" || fail "the desktop file is wrong"
fi
if has appstreamcli; then
    for file in "$share/metainfo/org.vitrine.Vitrine.metainfo.xml" "$root/published.metainfo.xml"; do
        appstreamcli validate --no-net "$file" || fail "the AppStream file is wrong"
    done
fi
if has xmllint; then xmllint --noout "$share/mime/packages/org.vitrine.Vitrine.xml"; fi
gzip -dc "$share/man/man1/vitrine.1.gz" >"$root/vitrine.1"
for section in 'EXIT STATUS' FILES ENVIRONMENT EXAMPLES 'SEE ALSO'; do
    grep -A 3 "^\.SH $section\$" "$root/vitrine.1" | grep -qv '^\.SH' || fail "the manual page lacks $section"
done
for code in 0 1 2 3 4 5 130; do
    sed -n '/^.SH EXIT STATUS/,/^.SH FILES/p' "$root/vitrine.1" | grep -qx "\.B $code" || fail "the manual page lacks the exit status $code"
done
if has man; then
    warnings=$(LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l "$root/vitrine.1" 2>&1 >/dev/null)
    [ -z "$warnings" ] || fail "the manual page is wrong: $warnings"
fi
if has mandoc; then
    mandoc -T lint -W warning "$root/vitrine.1" || fail "the manual page is wrong"
fi
if has bash; then
    words=$(bash -c '. "$1"; COMP_WORDS=(vitrine ren); COMP_CWORD=1; _vitrine; echo "${COMPREPLY[@]}"' - \
        "$share/bash-completion/completions/vitrine")
    [ "$words" = render ] || fail "bash completes \"ren\" to \"$words\""
fi
if has zsh; then zsh -n "$share/zsh/vendor-completions/_vitrine" || fail "the completion for zsh is wrong"; fi

if has dpkg-shlibdeps && has lintian; then
    (cd "$build" && cpack -G DEB -B "$root/packages") >"$root/log" 2>&1 || { cat "$root/log"; fail "cpack failed"; }
    lintian --fail-on error,warning "$root"/packages/vitrine_*.deb || fail "lintian has something against the package"
fi
[ "$asked" -gt 0 ] || exit 77
