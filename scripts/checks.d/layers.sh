# shellcheck shell=bash
# Checks that includes point down only, and that effects include only each other's public headers.
#
# Layers, from below: runtime, physics, sound (audio/effect) and lua, then side by side audio/synth with audio/device
# above it, render, and puzzle; insight; then side by side measure and game; game/ui; game/app. Tests and benches may include
# anything, and nothing may include them. Our headers are included with quotes: the root of the repository is an include
# path, so <> would find them too.
#
# The public headers of an effect (a folder of physics/ with a register.hpp, and audio/effect) are calls.hpp and
# properties.hpp or properties/. Of their own effect these include only properties.
#
# The interaction A <- B is in A's folder, as from_B. If A is in a lower layer, or B consists of interactions only
# (physics/motor), it is in B's folder, as A_from_B. B registers it: so register.cpp, and no other file, may include
# another effect's interactions/from_*. (A single place for all registrations would change their order, which is part of
# the simulation.)
#
# Files that effects share (physics/*.hpp, physics/inverse_square) include none of them; only register_physics.cpp
# includes the register.hpp of all.
#
# Folders above the effects include their public headers and register.hpp. The budget, the ladders, the hard cases, the
# SPICE export, the synthesiser and the sound rings may also include the pure functions from which derived property sets
# are computed: the folders and files of `pure` below. No other effect or folder includes core/, rules/, interactions/ or
# engines/.
set -euo pipefail

effects=(audio/effect)
for face in physics/*/register.hpp; do
    effects+=("$(dirname "$face")")
done
folders=()
for folder in runtime physics audio lua render puzzle insight measure game; do
    if [[ -d $folder ]]; then
        folders+=("$folder")
    fi
done

grep -rnE --include='*.[ch]pp' --include='*.inc' '^[[:space:]]*#[[:space:]]*include[[:space:]]*["<]' "${folders[@]}" |
    awk -v effects="${effects[*]}" '
    function layer(path) {
        if (path ~ /^game\/(app|ui)\//) return substr(path, 6, index(substr(path, 6), "/") - 1)
        if (path ~ /^audio\/effect\//) return "sound"
        if (path ~ /^audio\//) return substr(path, 7, index(substr(path, 7), "/") - 1)
        return substr(path, 1, index(path, "/") - 1)
    }
    function effect_of(path,   i) { # the effect whose folder it is in, or ""
        for (i in effect) if (index(path, effect[i] "/") == 1) return effect[i]
        return ""
    }
    function complain(what) {
        printf "%s includes %s: %s\n", place, to, what
        wrong++
    }
    BEGIN {
        split(effects, effect, " ")
        pure = "^(physics/buoyancy/hulls/|physics/electricity/analyses/|physics/magnetism/magnetic_|audio/effect/hearing/)"
        below["runtime"] = "runtime"
        below["physics"] = "runtime physics"
        below["sound"] = "runtime physics sound"
        below["lua"] = "runtime physics lua"
        below["synth"] = "runtime physics sound synth"
        below["device"] = "runtime physics sound synth device"
        below["render"] = "runtime physics render"
        below["puzzle"] = "runtime physics sound lua puzzle"
        below["insight"] = "runtime physics sound lua puzzle insight"
        below["measure"] = "runtime physics sound lua puzzle measure"
        below["game"] = "runtime physics sound lua puzzle insight game"
        below["ui"] = "runtime physics sound lua synth device render puzzle insight game ui"
        below["app"] = "runtime physics sound lua synth device render puzzle insight measure game ui app"
    }
    {
        split($0, part, ":")
        from = part[1]
        place = from ":" part[2]
        to = $0
        sub(/^[^"<]*/, "", to)
        quoted = to ~ /^"/
        to = substr(to, 2)
        sub(/[">].*/, "", to)
        if (!quoted) {
            if (to ~ /^(runtime|physics|audio|lua|render|puzzle|insight|measure|game|tests|bench)\//) {
                complain("our headers are included with quotes")
            }
            next
        }
        seen++
        if (index(" " below[layer(from)] " ", " " layer(to) " ") == 0) {
            complain("that is not below " layer(from))
            next
        }
        mine = effect_of(from)
        other = effect_of(to)
        if (other == "") next
        inside = substr(to, length(other) + 2)
        public = inside ~ /^(calls\.hpp|properties\.hpp|properties\/.*)$/
        if (mine == other) {
            if (substr(from, length(mine) + 2) ~ /^(calls\.hpp|properties\.hpp|properties\/)/ &&
                inside !~ /^properties(\.hpp|\/)/) {
                complain("public headers include only properties of their effect")
            }
        } else if (mine != "") {
            if (!public && !(from == mine "/register.cpp" && inside ~ /^interactions\/from_/)) {
                complain("that is not for other effects (calls.hpp and properties are)")
            }
        } else if (from ~ /^physics\// && from != "physics/register_physics.cpp") {
            complain("code that effects share must not include an effect")
        } else if (!public && inside != "register.hpp" && (from ~ /^(physics|render)\// || to !~ pure)) {
            complain("that is not for others (calls.hpp, properties, register.hpp and pure functions are)")
        }
    }
    END {
        if (seen == 0) {
            print "no include was found at all"
            exit 1
        }
        exit wrong > 0
    }'
