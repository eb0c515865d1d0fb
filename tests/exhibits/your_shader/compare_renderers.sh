#!/bin/sh
# sh tests/exhibits/your_shader/compare_renderers.sh FOLDER [STEP [FOLDER_FOR_PICTURES]]
# Compares our pictures of the ISF files of a folder with those of interactive-shader-format, the format's own renderer in
# JavaScript, in headless Chromium: same initial values, input pictures, size and time. STEP is as in corpus.sh.
# Prints a line for each file on standard error, and tables in Markdown on standard output. Ends with 1 if fewer than 95 % of the
# files within the limits of the other renderer have an RMSE of at most .02 of the display values. Needs build/release/vitrine.
set -e
cd "$(dirname "$0")/../../.."
[ -d "$1" ] || { echo "compare_renderers.sh: name a folder of .fs files" >&2; exit 2; }
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ -z "$chromium" ] || ! command -v node >/dev/null || ! command -v npm >/dev/null; then
    echo "compare_renderers.sh: it needs Chromium, node and npm (Debian: chromium, nodejs, npm)" >&2
    exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$work" && npm init -y >/dev/null && npm install --silent --no-audit --no-fund --ignore-scripts interactive-shader-format@2.9.0 &&
    npm install --silent --no-audit --no-fund esbuild@0.25.0 &&
    echo 'module.exports = {};' > none.js && node_modules/.bin/esbuild --bundle --alias:crypto=./none.js --global-name=isf --outfile=isf.js --log-level=error \
        node_modules/interactive-shader-format/src/main.js) >&2
LIBGL_ALWAYS_SOFTWARE=${LIBGL_ALWAYS_SOFTWARE:-1} node tests/exhibits/your_shader/compare_renderers.mjs "$1" "${2:-1}" "$work" "$chromium" "$3"
