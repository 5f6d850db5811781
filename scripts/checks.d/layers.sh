# shellcheck shell=bash
# Includes point down only, and an effect shows others nothing but its public face.
#
# Layers, from below: runtime, physics, sound (audio/effect), then side by side audio/synth with audio/device above it,
# render, and puzzle; then side by side measure and game; game/ui; game/app. Tests and benches may look at anything,
# and nothing may look at them.
#
# The face of an effect (a folder of physics/ with a register.hpp, and audio/effect) is calls.hpp and properties.hpp or
# properties/. What stands in properties/ includes nothing else of its effect. Interactions A <- B live with A and are
# registered by B, if B is there: so register.cpp, and nothing else, may include another effect's interactions/from_*.
# (Whoever registers all of them in one place would register them in another order, and that is part of the simulation.)
# What effects share (physics/*.hpp, physics/inverse_square) knows none of them; register_physics.cpp knows the faces and
# the register.hpp of all, and nothing behind them.
#
# Whoever stands above the effects sees their faces, too, and register.hpp. The budget, the ladders, the hard cases, the
# SPICE export, the synthesiser and the sound rings evaluate besides what derived property sets are made of, which are pure
# functions and change nothing: the folders and files of `pure` below. Nobody outside sees core/, rules/, interactions/ or
# engines/.
set -euo pipefail

effects=(audio/effect)
for face in physics/*/register.hpp; do
    effects+=("$(dirname "$face")")
done
folders=()
for folder in runtime physics audio render puzzle measure game; do
    if [[ -d $folder ]]; then
        folders+=("$folder")
    fi
done

grep -rnE --include='*.[ch]pp' --include='*.inc' '^[[:space:]]*#[[:space:]]*include[[:space:]]+"' "${folders[@]}" |
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
        below["synth"] = "runtime physics sound synth"
        below["device"] = "runtime physics sound synth device"
        below["render"] = "runtime physics render"
        below["puzzle"] = "runtime physics sound puzzle"
        below["measure"] = "runtime physics sound puzzle measure"
        below["game"] = "runtime physics sound puzzle game"
        below["ui"] = "runtime physics sound synth device render puzzle game ui"
        below["app"] = "runtime physics sound synth device render puzzle measure game ui app"
    }
    {
        split($0, part, ":")
        from = part[1]
        place = from ":" part[2]
        to = $0
        sub(/^[^"]*"/, "", to)
        sub(/".*/, "", to)
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
            if (from ~ /\/properties\// && inside !~ /^properties\//) {
                complain("what properties/ shows must not lead further in")
            }
        } else if (mine != "") {
            if (!public && !(from == mine "/register.cpp" && inside ~ /^interactions\/from_/)) {
                complain("that is not for other effects (calls.hpp and properties are)")
            }
        } else if (from ~ /^physics\// && from != "physics/register_physics.cpp") {
            complain("what effects share knows none of them")
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
