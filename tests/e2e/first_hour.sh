#!/usr/bin/env bash
# Frequent mistakes of new users and the messages they get; the record that a run keeps of how it was made.
# usage: first_hour.sh SCREE SOURCE
set -euo pipefail
scree=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "first_hour.sh: $*" >&2; exit 1; }
# says CODE TEXT COMMAND...: the command must end with this exit code and print this text
says() {
  local code=$1 text=$2 found=0
  shift 2
  "$@" >said 2>&1 || found=$?
  [ $found = "$code" ] || { cat said; fail "'${*:2}' ends with $found, not $code"; }
  grep -qF -- "$text" said || { cat said; fail "'${*:2}' does not say: $text"; }
}
# once PATTERN: exactly one line of the last output matches
once() { [ "$(grep -c -- "$1" said)" = 1 ] || { cat said; fail "not once: $1"; }; }

cat >fall.toml <<'END'
title = "A box on its base"
material.rock = { density = 2600.0, young = "1 GPa", poisson = 0.2 }
joint.plane = { friction_deg = 30.0 }
support = [{ block = "base" }]
block = [
  { name = "base", material = "rock", polygon = [[0, 0], [4, 0], [4, 1], [0, 1]] },
  { name = "box-1", material = "rock", polygon = [[0, 1], [1, 1], [1, 2], [0, 2]] },
  { name = "box-2", material = "rock", polygon = [[2, 1], [3, 1], [3, 2], [2, 2]] },
  { name = "box-3", material = "rock", polygon = [[3, 1], [4, 1], [4, 2], [3, 2]] },
]
stage = [{ name = "rest", method = "dda", integrator = "implicit", dt = "1 ms", duration = 0.01 }]
END

# commands, options
says 2 'did you mean "snapshot"?' "$scree" snapshop run
says 2 'scree has no command "foo"' "$scree" foo
says 2 'did you mean "verify"?' "$scree" cases verfy
says 2 'no command given' "$scree"
says 2 'Did you mean --overwrite?' "$scree" run fall.toml --overwrit
# keys, units
says 3 'did you mean "friction_deg"?' "$scree" check fall.toml --set joint.plane.fric_deg=20
says 3 'did you mean "friction_deg"?' "$scree" check fall.toml --set joint.plane.phi=20
says 3 'divide by g: 26 kN/m3 / 9.81 m/s2 = 2650 kg/m3' "$scree" check fall.toml --set 'material.rock.density="26 kN/m3"'
says 3 'multiply by g' "$scree" check fall.toml --set 'water=[{line=[[0,1],[4,1]],unit_weight="1 t/m3"}]'
says 0 fine "$scree" check fall.toml --set 'material.rock.young="0.001 TPa"'
says 0 "warning: the density of 'rock' is 2.6 kg/m3" "$scree" check fall.toml --set material.rock.density=2.6
says 0 "warning: Young's modulus of 'rock' is 25 Pa" "$scree" check fall.toml --set material.rock.young=25
# contents of a case
says 0 'base, box-1 to box-3' "$scree" check fall.toml
says 0 'box-2' "$scree" check fall.toml --blocks
grep -q '2.5 .*1.5 .*rock' said || fail 'check --blocks has no centre'
# an explicit stage: its step, and the block that limits it; check refuses a step that the run would refuse
explicit=(--set 'stage.rest.integrator="explicit"')
says 0 "0.8 of the certified bound, set by block 'box-" "$scree" check fall.toml "${explicit[@]}" --set 'stage.rest.dt="auto"'
says 3 'above the certified stable one' "$scree" check fall.toml "${explicit[@]}" --set stage.rest.dt=0.01
says 0 'is forced above' "$scree" check fall.toml "${explicit[@]}" --set stage.rest.dt=0.01 --set stage.rest.force_dt=true

# a warning: printed by check and by the run, also with --quiet; contained in run.log and in summary.json
loose='block.box-3.polygon=[[3.1,1.1],[4,1.1],[4,2.1],[3.1,2.1]]'
says 0 "warning: block 'box-3' touches nothing" "$scree" check fall.toml --set "$loose"
once "touches nothing"
grep -q 'valid, with a warning' said || fail 'check does not count the warnings'
says 0 '1 warning: see run.log' "$scree" run fall.toml --set "$loose" --out runs/a --live="file://$work/a.log"
once "touches nothing"
says 0 "warning: block 'box-3' touches nothing" "$scree" run fall.toml --set "$loose" --out runs/b --quiet
once "touches nothing"
[ "$(wc -l <said)" = 1 ] || { cat said; fail '--quiet prints more than the warning'; }
grep -q '\[warning\].*touches nothing' runs/a/run.log || fail 'the warning is not in run.log'
grep -qvE '^[0-9]{4}-[0-9]{2}-[0-9]{2} ' runs/a/run.log && fail 'run.log has lines of another pattern'
python3 - "$loose" <<'END'
import json, sys
run = json.load(open("runs/a/summary.json"))
assert run["set"] == [sys.argv[1]], run["set"]
assert " --out runs/a " in run["command_line"], run["command_line"]
assert len(run["warnings"]) == 1 and "box-3" in run["warnings"][0]["text"] and run["warnings"][0]["time"] == 0, run["warnings"]
END

# an earlier run is not overwritten by accident
says 5 '--overwrite' "$scree" run fall.toml --out runs/a
says 0 'results in' "$scree" run fall.toml --out runs/a --overwrite
python3 -c 'import json; assert json.load(open("runs/a/summary.json"))["warnings"] == []'

# two runs of one case stream under two names
tr -c '[:print:]' '\n' <a.log >names
grep -q SCREE_a_INFO names || fail 'the run does not stream under the name of its folder'
says 0 'results in' "$scree" run fall.toml --out runs/c --live="file://$work/c.log" --name second
tr -c '[:print:]' '\n' <c.log >names
grep -q SCREE_second_INFO names || fail '--name does not name the stream'

# a resumed run keeps its earlier warnings
says 0 'results in' "$scree" run fall.toml --set "$loose" --out runs/d --until 0.005
says 0 'going on with' "$scree" resume runs/d --until 0.01
grep -qvE '^[0-9]{4}-[0-9]{2}-[0-9]{2} ' runs/d/run.log && fail 'the log of a resumed run has lines of another pattern'
python3 -c 'import json; w = json.load(open("runs/d/summary.json"))["warnings"]; assert len(w) == 1, w'

# the keys of the manual
for command in run resume check sweep watch control replay snapshot report view; do
  grep -q "^\.B scree $command\$" "$source/docs/scree.1" || fail "the synopsis of the manual lacks 'scree $command'"
done
echo "first_hour.sh: all said"
