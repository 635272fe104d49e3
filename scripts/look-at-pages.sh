#!/usr/bin/env bash
# Pages as a person sees them: screenshots at the width of a desktop, light and dark, and of a phone, and PDF on A4 and letter with
# their pages as pictures.
#
# Needs Chromium and poppler's tools (Debian: `apt-get install chromium poppler-utils fonts-liberation`). Not part of the gate: what
# it makes is to be looked at.
#
#   scripts/look-at-pages.sh [FOLDER]        target/pages unless a folder is named
#
# Prints the number of sheets of each page. Chromium runs with an empty profile of its own and fetches nothing.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(realpath -m "${1:-target/pages}")
mkdir -p "$folder"
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT
cargo build --quiet --package epicyclic
program="${CARGO_TARGET_DIR:-target}/debug/epicyclic"

browser() {
    chromium --headless --no-sandbox --disable-gpu --disable-background-networking --no-first-run --disable-sync \
        --hide-scrollbars --user-data-dir="$profile" "$@" 2>/dev/null
}

look() {
    local name=$1
    shift
    for paper in a4 letter; do
        "$program" "$@" --paper "$paper" -o "$folder/$name-$paper.html" 2>/dev/null
        browser --no-pdf-header-footer --print-to-pdf="$folder/$name-$paper.pdf" "file://$folder/$name-$paper.html"
        pdftoppm -r 70 -png "$folder/$name-$paper.pdf" "$folder/$name-$paper"
        printf '%s, %s: %s sheets\n' "$name" "$paper" "$(pdfinfo "$folder/$name-$paper.pdf" | sed -n 's/^Pages: *//p')"
    done
    local page="file://$folder/$name-a4.html"
    browser --window-size=1280,3000 --screenshot="$folder/$name-desktop.png" "$page"
    browser --window-size=1280,3000 --blink-settings=preferredColorScheme=0 --screenshot="$folder/$name-dark.png" "$page"
    # A window is never as narrow as a phone; a frame in it is.
    printf '<body style="margin:0"><iframe src="%s" style="width:390px;height:3000px;border:0"></iframe>\n' "$page" \
        >"$folder/$name-phone.html"
    browser --window-size=500,3000 --screenshot="$folder/$name-phone.png" "file://$folder/$name-phone.html"
    rm "$folder/$name-phone.html"
}

for file in examples/*.yaml; do
    case $file in
        */real-transmissions.yaml)
            for name in 8HP TH400 AOD prius NREL; do
                look "$name" report "$file" --transmission "$name" --efficiency 97%
            done
            ;;
        *) look "$(basename "$file" .yaml)" report "$file" ;;
    esac
done
look D.T1.B+T2.B.T1 report D.T1.B+T2.B.T1 --ratio1 2.618 --ratio2 1.4623
look select select --speeds '0.76 m/s, 1.33 m/s, 1.95 m/s' --all-structures --power 75kW --input 1475rpm
look synthesize synthesize --ratios '2.56, 1.465'
look motor motor --stator 5 --rotor 3 --z3 55 --zs 10 --module '2 mm' --l '80 mm' --width '50 mm' --pressure '20 MPa'
