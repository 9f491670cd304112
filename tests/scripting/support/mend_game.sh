#!/bin/sh
# Plays the game GAME until it fails, saves its main.lua changed by a sed script, and prints what it printed.
# Usage: mend_game.sh CAIRN GAME SED-BEFORE SED-AFTER...
# SED-BEFORE makes the text that fails with the word "slip", each SED-AFTER what is saved when it has failed once more.
# Exits as the game does; a game that neither fails nor ends within 20 s is killed.
cairn=$1
source=$2
before=$3
shift 3
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
mkdir "$folder/game"
sed "$before" "$source/main.lua" > "$folder/game/main.lua"
: > "$folder/out"
XDG_DATA_HOME=$folder "$cairn" play "$folder/game" > "$folder/out" 2>&1 &
game=$!
ticks=0
failed=1
for after; do
  until [ "$(grep -c slip "$folder/out")" -ge $failed ] || [ $ticks -ge 100 ]; do sleep 0.1; ticks=$((ticks + 1)); done
  failed=$((failed + 1))
  sleep 1.1 # the watch has seen the file as it is
  sed -i "$after" "$folder/game/main.lua"
done
while kill -0 $game 2> /dev/null && [ $ticks -lt 200 ]; do sleep 0.1; ticks=$((ticks + 1)); done
kill -9 $game 2> /dev/null
wait $game
status=$?
cat "$folder/out"
exit $status
