#!/bin/sh
# Plays the game GAME until it fails, saves its main.lua mended by a sed script, and prints what it printed.
# Usage: mend_game.sh CAIRN GAME SED-BEFORE SED-AFTER
# SED-BEFORE makes the text that fails, SED-AFTER the mended one of it. Exits as the game does; a game that neither
# fails nor ends within 20 s is killed.
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
mkdir "$folder/game"
sed "$3" "$2/main.lua" > "$folder/game/main.lua"
: > "$folder/out"
XDG_DATA_HOME=$folder "$1" play "$folder/game" > "$folder/out" 2>&1 &
game=$!
ticks=0
until grep -q slip "$folder/out" || [ $ticks -ge 100 ]; do sleep 0.1; ticks=$((ticks + 1)); done
sleep 1.1 # the watch has seen the file as it is
sed -i "$4" "$folder/game/main.lua"
while kill -0 $game 2> /dev/null && [ $ticks -lt 200 ]; do sleep 0.1; ticks=$((ticks + 1)); done
kill -9 $game 2> /dev/null
wait $game
status=$?
cat "$folder/out"
exit $status
