#!/bin/sh
# Starts Vitrine from the folder in which this file lies.
here=$(dirname "$(readlink -f "$0")")
have=$( (ldconfig -p || /sbin/ldconfig -p) 2>/dev/null | sed -n 's/^[[:space:]]*\([^ ]*\) (libc6,x86-64[^)]*) => /\1 /p')
# A library of lib/fallback is used where the system has none or an older one.
for folder in "$here"/lib/fallback/*/; do
    name=$(basename "$folder")
    system=$(printf '%s\n' "$have" | sed -n "s|^$name ||p" | head -n 1)
    if [ -n "$system" ]; then
        newest=$(printf '%s\n%s\n' "$(basename "$(readlink -f "$system")")" "$(cat "$folder/version")" | sort -V | tail -n 1)
        [ "$newest" != "$(basename "$(readlink -f "$system")")" ] || continue
    fi
    LD_LIBRARY_PATH="${folder%/}${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
done
[ -z "$LD_LIBRARY_PATH" ] || export LD_LIBRARY_PATH
exec "$here/bin/${VITRINE_PORTABLE_PROGRAM:-vitrine}" "$@"
