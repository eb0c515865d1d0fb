#!/bin/sh
# Builds the portable folder build/portable/vitrine and its archive build/portable/vitrine-x86_64.tar.xz: the program, and
# run-benchmarks, which prints the report of a machine.
set -e
cd "$(dirname "$0")/../.."
. app/packages.sh
need patchelf xz-utils
build vitrine vitrine_oiio vitrine_video vitrine_draco vitrine_gamepad vitrine_editor vitrine_shader_compiler benchmarks
exec sh app/install/portable.sh build/release build/portable/vitrine build/portable/vitrine-x86_64.tar.xz build/release/tests/benchmarks
