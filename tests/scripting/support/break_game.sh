#!/bin/sh
# Runs the tests of the game GAME with its main.lua changed by a sed script, and exits as they do.
# Usage: break_game.sh CAIRN GAME SED
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cp -r "$2" "$folder/game"
sed -i "$3" "$folder/game/main.lua"
cmp -s "$2/main.lua" "$folder/game/main.lua" && { echo "nothing was changed by $3"; exit 2; }
"$1" test "$folder/game"
