# Sourced by app/run and tests/run: installs what is missing. Prints to standard error only.

# By the names that Debian 12, Debian 13 and Ubuntu 24.04 share: libraries come with the -dev packages, whatever they are
# called since the 64-bit time_t. A name with a question mark is asked for only where there is a package of that name:
# Debian 12 has Qt's OpenGL headers in one of their own, Debian 13 in qt6-base-dev.
build_packages="cmake ninja-build g++ pkg-config ccache qt6-base-dev libqt6opengl6-dev? qt6-svg-dev qt6-l10n-tools qt6-translations-l10n? libqcustomplot-dev libqscintilla2-qt6-dev libgl-dev libegl-dev
libepoxy-dev libglm-dev libopenimageio-dev liblcms2-dev libqpdf-dev libtinygltf-dev libbullet-dev nlohmann-json3-dev libcli11-dev libpng-dev zlib1g-dev libisal-dev
glslang-dev glslang-tools libspirv-cross-c-shared-dev
libavcodec-dev libavfilter-dev libavformat-dev libavutil-dev libsdl2-dev liblo-dev librtmidi-dev libmd4c-dev libmeshoptimizer-dev libdraco-dev
libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev
libegl1 libgl1 libgl1-mesa-dri libegl-mesa0 libglx-mesa0 fonts-dejavu-core"

installed() {
    [ "$(dpkg-query -W -f '${Status}' "$1" 2>/dev/null)" = "install ok installed" ]
}

# available PACKAGE...: prints those that apt can install here.
available() {
    for package in "$@"; do
        if LC_ALL=C apt-cache policy "$package" 2>/dev/null | grep -q 'Candidate: [0-9]'; then printf ' %s' "$package"; fi
    done
}

# need PACKAGE...: installs those that are not there; returns at once when all are.
need() {
    if ! command -v dpkg-query >/dev/null 2>&1; then
        echo "vitrine: this system has no dpkg. Install what these Debian packages hold, then build with" >&2
        echo "  cmake --preset release && cmake --build build/release" >&2
        echo "$@" >&2
        return 0
    fi
    missing=""
    perhaps=""
    for package in "$@"; do
        installed "${package%\?}" && continue
        case "$package" in
            *\?) perhaps="$perhaps ${package%\?}" ;;
            *) missing="$missing $package" ;;
        esac
    done
    # Package lists may be missing or old before the update below, hence only here: what is to be had, will be installed.
    # shellcheck disable=SC2086
    [ -n "$missing" ] || missing=$(available $perhaps)
    [ -n "$missing" ] || return 0
    as_root=""
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null 2>&1; then
            echo "vitrine: these packages are missing; install them as root and start again:" >&2
            echo "  apt-get install$missing" >&2
            return 1
        fi
        as_root="sudo"
    fi
    echo "vitrine: installing$missing" >&2
    $as_root apt-get update -q >&2 || echo "vitrine: apt-get update failed; trying with the package lists at hand" >&2
    # shellcheck disable=SC2046,SC2086
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing$(available $perhaps) >&2
}

# build PRESET TARGET...: configures once and builds in the preset's folder, quietly unless something is to be done. From nothing,
# few large files take two minutes less on two cores than many small ones; `cmake --preset release` alone configures for small
# changes. VITRINE_WARNINGS_AS_ERRORS=ON makes errors of warnings.
build() {
    preset=$1
    shift
    if [ ! -f "build/$preset/build.ninja" ]; then
        cmake --preset "$preset" -DVITRINE_UNITY_BUILD=ON -DVITRINE_WARNINGS_AS_ERRORS="${VITRINE_WARNINGS_AS_ERRORS:-OFF}" >&2 || return 1
    fi
    cmake --build "build/$preset" --target "$@" >&2
}
