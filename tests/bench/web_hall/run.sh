#!/bin/sh
# The empty hall as the case hall_costs of benchmarks draws it beside the same hall as a plain page of three.js does, in one run:
# prints one table. Needs Chromium, node and npm; says so and ends with 77 where they are not.
#   sh tests/bench/web_hall/run.sh [ROUNDS]
set -e
cd "$(dirname "$0")/../../.."
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ -z "$chromium" ] || ! command -v node >/dev/null || ! command -v npm >/dev/null; then
    echo "web_hall: not measured: it needs Chromium, node and npm (Debian: chromium, nodejs, npm)" >&2
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
(cd "$folder" && npm init -y >/dev/null && npm install --silent --no-audit --no-fund three@0.182.0) >&2
LIBGL_ALWAYS_SOFTWARE=1 node tests/bench/web_hall/compare.mjs "$PWD" "$folder/node_modules/three" "$chromium" build/release/tests/benchmarks "${1:-3}"
