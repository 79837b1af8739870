#!/bin/bash
# Draws the pictures of ORIGINAL.md: left what the original's way of doing things makes of a scene, right what ours makes.
# Needs the built program and ImageMagick (apt install imagemagick).   ./draw.sh [PASSGRAPH]
set -euo pipefail
cd "$(dirname "$0")"
passgraph=$(realpath "${1:-../../../build/release/bin/passgraph}")
pictures=../pictures
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
mkdir -p "$pictures"

draw() { # SCENE OUTPUT…
    local scene=$1 outputs=()
    shift
    for output in "$@"; do outputs+=(--out "$output=$drawn/$(basename "$scene" .scene.json)_$output.png"); done
    "$passgraph" render comparison.graph.json --passes . --scene "$scene" --size 800x450 "${outputs[@]}"
}

pair() { # NAME BEFORE AFTER [CROP]
    convert "$drawn/$2.png" "$drawn/$3.png" ${4:+-crop "$4" +repage} -resize 400x225! -bordercolor black \
        +append -strip -quality 86 "$pictures/$1.jpg"
}

draw ../resources/scenes/night_lamp.scene.json ours alpha position mirror blurred their_blurred cells their_cells night their_night
draw wall.scene.json ours normals
draw grazing.scene.json ours terms

pair alpha night_lamp_alpha night_lamp_ours
pair position night_lamp_position night_lamp_ours
pair normals wall_normals wall_ours
pair cube_map night_lamp_mirror night_lamp_ours
pair blur night_lamp_their_blurred night_lamp_blurred
pair lighting grazing_terms grazing_ours
pair cells night_lamp_their_cells night_lamp_cells 160x90+390+230
pair night_vision night_lamp_their_night night_lamp_night
ls -l "$pictures"
