#!/bin/sh
# help_texts.sh PROGRAM FOLDER: writes the manual page and the completions for bash and zsh, made of the program's help
# texts, the compressed change log, and the copyright with the font's license. The same bytes for the same program.
set -e
program=$1
folder=$2
here=$(dirname "$0")
export LC_ALL=C.UTF-8
mkdir -p "$folder"

# The names in the list of sub-commands of `program ...`.
commands_of() {
    "$program" "$@" --help | awk '/^Subcommands:/ { on = 1; next } /^[^ ]/ { on = 0 } on && /^  [a-z]/ { print $1 }'
}

# Every command that takes options, one a line: "render", "scene check", ...
all_commands() {
    for command in $(commands_of); do
        below=$(commands_of "$command")
        if [ -z "$below" ]; then echo "$command"; fi
        for each in $below; do echo "$command $each"; done
    done
}

options_of() {
    # shellcheck disable=SC2086
    "$program" $1 --help | awk '/^  -/ { for (i = 1; i <= NF && $i ~ /^-/; ++i) { sub(/,$/, "", $i); n = split($i, names, ",")
        for (k = 1; k <= n; ++k) if (names[k] ~ /^--[a-z]/) print names[k] } }' | tr '\n' ' '
}

# Help text to roff: an option or a word with two spaces before it begins an entry; what follows it, or stands deeper, is its text.
roff() {
    sed -e 's/\\/\\e/g' -e 's/-/\\-/g' | awk '
        function text(s) { sub(/^ +/, "", s); if (s ~ /^[.\047]/) s = "\\&" s; if (s != "") print s }
        /^Usage:/ { next }
        /^[A-Z][A-Za-z ]*:$/ { next }
        /^[^ ]/ { if (entry) print ".PP"; entry = 0 }
        /^  [^ ]/ { entry = 1; line = substr($0, 3); at = match(line, /   *[^ ]/)
            print ".TP"; print "\\fB" (at ? substr(line, 1, at - 1) : line) "\\fR"; if (at) text(substr(line, at)); next }
        { text($0) }'
}

# The closing sections. Exit codes are those of the program's help, examples are the commands of README.md, and
# environment.txt has the variables that the program reads (tests/environment compares them).
sections() {
    printf '.SH EXIT STATUS\n'
    { "$program" --help | tr '\n' ' '; echo; } | sed 's/.*Exit codes: *//; s/\. *\(Usage\|vitrine\).*//; s/  */ /g; s/, \([0-9]\)/\n\1/g' | sed 's/-/\\-/g' |
        while read -r code text; do printf '.TP\n.B %s\n%s\n' "$code" "$text"; done
    printf '.SH FILES\n'
    while IFS='	' read -r path text; do printf '.TP\n.I %s\n%s\n' "$path" "$text"; done <<EOF
~/.config/vitrine	Settings of the window.
~/.local/share/vitrine/presets	Your presets, a folder for each exhibit.
~/.local/state/vitrine	Kept work: the last session, and what a crash would lose.
~/.cache/vitrine/programs	Compiled shader programs. They can be deleted at any time.
/usr/share/vitrine	Models, presets, lessons, pages and fonts. Their licenses are in SOURCES.md.
/usr/share/doc/vitrine/README.md	The manual, which Help > Manual opens.
EOF
    printf '.SH ENVIRONMENT\n'
    sed 's/-/\\-/g' "$here/environment.txt" |
        while IFS='	' read -r names text; do printf '.TP\n.B %s\n%s\n' "$names" "$text"; done
    printf '.SH EXAMPLES\n'
    sed -n 's/^\(vitrine [^#]*[^# ]\) *\(# .*\)*$/\1/p' "$here/../../README.md" | sed 's/\\/\\e/g; s/-/\\-/g' |
        while read -r line; do printf '.PP\n.nf\n.B %s\n.fi\n' "$line"; done
    printf '.SH SEE ALSO\n.BR ffmpeg (1),\n.BR sbatch (1)\n.PP\nThe manual: /usr/share/doc/vitrine/README.md\n'
}

# The number without the commit, and the day of the newest entry of the change log.
version=$("$program" --version | sed 's/^vitrine //; s/+.*//')
day=$(date -u -d "$(sed -n 's/^ -- .*>  //p' "$here/changelog" | head -n 1)" +%Y-%m-%d)
{
    printf '.TH VITRINE 1 "%s" "Vitrine %s" "User Commands"\n.SH NAME\n' "$day" "$version"
    printf 'vitrine \\- museum and workbench of real\\-time rendering techniques\n'
    printf '.SH SYNOPSIS\n.B vitrine\n[\\fICOMMAND\\fR [\\fIOPTIONS\\fR]]\n.SH DESCRIPTION\n'
    "$program" --help | awk '/^Usage:/ { exit } { print }' | roff
    printf '.SH COMMANDS\n'
    "$program" --help | awk '/^Subcommands:/ { on = 1; next } on' | roff
    all_commands | while read -r command; do
        printf '.SH %s\n' "$(echo "vitrine $command" | tr '[:lower:]' '[:upper:]' | sed 's/-/\\-/g')"
        # shellcheck disable=SC2086
        "$program" $command --help </dev/null | roff
    done
    sections
} | gzip -9n >"$folder/vitrine.1.gz"

# For each command, the pattern of a `case` and the words that may follow, with a bar between.
words=$(for command in $(commands_of); do
    for each in $(commands_of "$command"); do printf '"%s %s")|%s\n' "$command" "$each" "$(options_of "$command $each")"; done
    printf '"%s "*)|%s\n' "$command" "$(commands_of "$command" | tr '\n' ' ')$(options_of "$command")"
done)

{
    printf '# bash completion for vitrine, made of its help texts.\n_vitrine() {\n'
    printf '    local word=${COMP_WORDS[COMP_CWORD]} words\n    case "${COMP_WORDS[1]} ${COMP_WORDS[2]}" in\n'
    echo "$words" | sed 's/^\(.*\)|\(.*\)$/        \1 words="\2" ;;/'
    printf '    esac\n    if [ "$COMP_CWORD" -eq 1 ]; then words="%s--help --version"; fi\n' "$(commands_of | tr '\n' ' ')"
    printf '    case "${COMP_WORDS[1]}:$COMP_CWORD" in\n        render:2 | record:2 | study:2) words="$words %s" ;;\n    esac\n' \
        "$("$program" list | awk '/^[a-z_]+( |$)/ { print $1 }' | tr '\n' ' ' | sed 's/ $//')"
    printf '    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")\n}\n'
    printf 'complete -o bashdefault -o default -F _vitrine vitrine\n'
} >"$folder/vitrine.bash"

{
    printf '#compdef vitrine\n# Made of the help texts of vitrine.\n_vitrine() {\n    local -a names\n'
    printf '    if (( CURRENT == 2 )); then\n        names=(%s--help --version)\n    else\n        case "$words[2] $words[3]" in\n' "$(commands_of | tr '\n' ' ')"
    echo "$words" | sed 's/^\(.*\)|\(.*\)$/            \1 names=(\2) ;;/'
    printf '        esac\n    fi\n    compadd -- $names\n    _files\n}\n_vitrine "$@"\n'
} >"$folder/_vitrine"

gzip -9nc "$here/changelog" >"$folder/changelog.gz"

# The last stanza of the copyright is the font's, whose license comes with it as Debian writes long texts.
{
    cat "$here/copyright"
    sed -e 's/^$/./' -e 's/^/ /' "$here/../../assets/fonts/OFL.txt"
} >"$folder/copyright"
