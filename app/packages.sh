# Sourced by app/run and tests/run: installs what is missing. Prints to standard error only.

build_packages="cmake ninja-build g++ pkg-config ccache qt6-base-dev qt6-svg-dev libqcustomplot-dev libqt6opengl6-dev libgl-dev libegl-dev
libepoxy-dev libglm-dev libopenimageio-dev libtinygltf-dev libbullet-dev nlohmann-json3-dev libcli11-dev libpng-dev
libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev
libegl1 libgl1 libgl1-mesa-dri libegl-mesa0 libglx-mesa0 fonts-dejavu-core"

# need PACKAGE...: installs those that are not there; returns at once when all are.
need() {
    missing=""
    if ! command -v dpkg-query >/dev/null 2>&1; then
        echo "vitrine: this system has no dpkg. Install what these Debian packages hold, then build with" >&2
        echo "  cmake --preset release && cmake --build build/release" >&2
        echo "$@" >&2
        return 0
    fi
    for package in "$@"; do
        case "$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null)" in
            "install ok installed") ;;
            *) missing="$missing $package" ;;
        esac
    done
    [ -z "$missing" ] && return 0
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
    # shellcheck disable=SC2086
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing >&2
}

# build TARGET...: configures once and builds, quietly unless something is to be done. From nothing, few large files take
# two minutes less on two cores than many small ones; `cmake --preset release` alone configures for small changes.
build() {
    if [ ! -f build/release/build.ninja ]; then
        cmake --preset release -DVITRINE_UNITY_BUILD=ON >&2 || return 1
    fi
    cmake --build build/release --target "$@" >&2
}
