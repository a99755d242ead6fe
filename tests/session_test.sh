#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs from the command line: every scene in one piece and resumed from pieces, signals,
# what is in the folder afterwards, and what is refused.
# shellcheck source=tests/shell.sh
. "$(dirname "$0")/shell.sh"

# One piece, and pieces stopped by the wall's clock at once and resumed: the same bits.
for scene in "$scenes"/*.yaml; do
    name=$(basename "$scene" .yaml)
    expect 0 "$brink" run "$scene" --events 6000 --out "$name-one"
    expect 75 "$brink" run "$scene" --events 6000 --out "$name-many" --max-wall 1e-9
    said 'stopped early'
    pieces=1
    while "$brink" resume "$name-many" --max-wall 1e-9 >out 2>err && false ||
        [ $? -eq 75 ]; do
        pieces=$((pieces + 1))
        [ "$pieces" -lt 100 ] || break
    done
    [ "$pieces" -gt 2 ] || fail "$name was resumed $pieces times only"
    cmp "$name-one/final.xyz" "$name-many/final.xyz" || fail "$name ends otherwise"
    strip='/wall_seconds\|events_per_second/d'
    sed "$strip" "$name-one/summary.json" >one.json
    sed "$strip" "$name-many/summary.json" >many.json
    cmp one.json many.json || fail "$name sums up otherwise"
    python3 -m json.tool "$name-one/summary.json" >out || fail "$name: no JSON"
    grep -q '"refused": 0' one.json || fail "$name: events were refused"
done

# A folder that holds a run is not overwritten; a finished one resumes to where it is.
expect 2 "$brink" run "$scenes/hard-spheres.yaml" --events 10 --out hard-spheres-one
said 'it holds a run already'
expect 0 "$brink" resume hard-spheres-one
said 'going on from 6000 events'
cmp hard-spheres-one/final.xyz hard-spheres-many/final.xyz || fail "resuming changed it"

# The seed and the target of the command line are the run's.
expect 0 "$brink" run "$scenes/hard-spheres.yaml" --seed 5 --events-per-particle 2 --out s
grep -q '"seed": 5,' s/summary.json || fail "the seed is not recorded"
count=$(sed -n 's/.*"particles": \([0-9]*\),/\1/p' s/summary.json)
grep -q "\"events\": $((2 * count))," s/summary.json || fail "not 2 events a particle"
expect 0 "$brink" run "$scenes/hard-spheres.yaml" --time 0.5 --out t
grep -q '"time": 0.5,' t/summary.json || fail "the time was not reached"

# SIGTERM stops with a checkpoint.
"$brink" run "$scenes/hard-spheres.yaml" --events 100000000 --out killed >out 2>err &
sleep 1
kill -TERM $!
wait $!
got=$?
[ "$got" -eq 75 ] || fail "SIGTERM gave exit $got, not 75"
said 'brink resume killed'

# A trajectory: frames at their times, none twice when the run is resumed in between.
sed 's/^run:.*/run: {time: 1}/' "$scenes/hard-spheres.yaml" >moving.yaml
echo 'output: {trajectory: 0.25}' >>moving.yaml
expect 0 "$brink" run moving.yaml --out film
expect 75 "$brink" run moving.yaml --out cut --max-wall 1e-9
while "$brink" resume cut --max-wall 1e-9 >out 2>err && false || [ $? -eq 75 ]; do :; done
[ "$(grep -c Lattice film/trajectory.xyz)" -eq 5 ] || fail "not five frames"
cmp film/trajectory.xyz cut/trajectory.xyz || fail "the resumed film is another"

# Observations: in one piece, in many, and many more: the same bits.  Of discs and of a
# mixture, so that all there is is there.
for name in discs mixture; do
    { sed '/^run:/d' "$scenes/$name.yaml"
      echo 'run: {time: 6}'
      echo 'observe: {every: 0.05, from: 0.5, distances: {up_to: 3}, speeds: true,'
      echo '          displacements: {up_to: 0.25}}'; } >seen.yaml
    expect 0 "$brink" run seen.yaml --out "$name-seen"
    expect 75 "$brink" run seen.yaml --out "$name-again" --max-wall 1e-9
    pieces=1
    while "$brink" resume "$name-again" --max-wall 0.01 >out 2>err && false ||
        [ $? -eq 75 ]; do pieces=$((pieces + 1)); done
    [ "$pieces" -gt 2 ] || fail "$name, observed, was resumed $pieces times only"
    for table in distances displacements speeds; do
        cmp "$name-seen/$table.dat" "$name-again/$table.dat" || fail "$name: $table differ"
    done
    sed "$strip" "$name-seen/summary.json" >one.json
    sed "$strip" "$name-again/summary.json" >many.json
    cmp one.json many.json || fail "$name, observed, sums up otherwise"
    python3 -m json.tool "$name-seen/summary.json" >out || fail "$name, observed: no JSON"
    grep -q '"samples": 111,' one.json || fail "$name: not 111 samples"
    # And the run is none the wiser.
    sed '/^observe/,$d' seen.yaml >unseen.yaml
    expect 0 "$brink" run unseen.yaml --out "$name-unseen"
    cmp "$name-seen/final.xyz" "$name-unseen/final.xyz" || fail "$name minds being seen"
    [ -e "$name-unseen/observed.html" ] && fail "$name was observed unasked"
done

# A folder that cannot be made.
expect 2 "$brink" run "$scenes/hard-spheres.yaml" --out no/such/place
said 'cannot be made'
finish
