#!/bin/sh
# Builds the portable folder build/portable/vitrine and its archive build/portable/vitrine-x86_64.tar.xz: the program, and
# run-benchmarks, which prints the report of a machine.
set -e
cd "$(dirname "$0")/../.."
. app/packages.sh
need patchelf optipng xz-utils
build release vitrine vitrine_oiio vitrine_video vitrine_draco vitrine_gamepad vitrine_editor vitrine_shader_compiler benchmarks
archive=build/portable/vitrine-x86_64.tar.xz
sh app/install/portable.sh build/release build/portable/vitrine "$archive" build/release/tests/benchmarks
if [ "$(stat -c %s "$archive")" -gt 60000000 ]; then
    echo "tests/bench/portable.sh: $archive is larger than 60 MB" >&2
    exit 1
fi
