#!/bin/sh
# sh assets/translations/update.sh           brings vitrine_de.ts up to date and lists what is still to be translated
# sh assets/translations/update.sh FILE...   the same, after taking translations from lines "English = German"
# sh assets/translations/update.sh --check   changes nothing; exit 1 where the file lacks a text or a translation
# The tables' texts come from the built program (build/release/vitrine); without it, those that are known are kept.
cd "$(dirname "$0")/../.." || exit 2
if ! command -v python3 >/dev/null 2>&1; then
    echo "update.sh: skipped: python3 is not here"
    exit 77
fi
exec python3 assets/translations/update.py "$@"
