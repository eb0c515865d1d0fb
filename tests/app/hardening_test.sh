#!/bin/sh
# hardening_test.sh FILE...: asks the headers and symbols of built programs and modules for what a hardened build has:
# position independence, read-only relocations that are all resolved at the start, stack protector and checked calls of
# the C library. Exit 77: readelf is not here.
command -v readelf >/dev/null 2>&1 || { echo "readelf was not found: install binutils"; exit 77; }
[ $# -gt 0 ] || { echo "hardening_test.sh FILE..."; exit 2; }
export LC_ALL=C
failed=0
fail() {
    echo "hardening_test: $1: $2"
    failed=1
}
checked=0
for file; do
    # Without symbols of its own a file has the dynamic ones, which name what it takes of libc.
    header=$(readelf -hW "$file") || { fail "$file" "is no program that readelf can read"; continue; }
    segments=$(readelf -lW "$file")
    dynamic=$(readelf -dW "$file")
    symbols=$(readelf --dyn-syms -W "$file")
    echo "$header" | grep -q 'Type: *DYN' || fail "$file" "has a fixed address; -fPIE and -pie are missing"
    echo "$segments" | grep -q 'GNU_RELRO' || fail "$file" "can have its relocations overwritten; -Wl,-z,relro is missing"
    echo "$dynamic" | grep -qE 'BIND_NOW|FLAGS_1.*NOW' || fail "$file" "resolves calls late; -Wl,-z,now is missing"
    echo "$segments" | grep -qE 'GNU_STACK.* RW ' || fail "$file" "has a stack that can be run"
    echo "$symbols" | grep -q '__stack_chk_fail' || fail "$file" "has no stack protector"
    if echo "$symbols" | grep -qE ' __[a-z]+_chk(@|$)'; then checked=1; fi
done
# A module that calls nothing that can be checked is as good; of all of them one does.
[ $checked = 1 ] || fail "$*" "no call of the C library is checked; -D_FORTIFY_SOURCE=2 is missing"
exit $failed
