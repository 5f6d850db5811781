// A table of the phenomena that each detail level cannot represent in any scene.
#include "measure/accuracy/ladder.hpp"

#include <array>
#include <string_view>

namespace trembler::accuracy {
namespace {

struct Limit {
    std::string_view effect;
    std::string_view level; ///< for settings, the part that the names of all their levels share
    std::string_view cannotRepresent;
};

constexpr std::array<Limit, 24> limits{{
    {"dynamics", "substep", "bending and breaking within a body: bodies are rigid"},
    {"dynamics", "velocity iteration", "bending and breaking within a body: bodies are rigid"},
    {"dynamics", "position iteration", "bending and breaking within a body: bodies are rigid"},
    {"gravity", "linear", "that anything but the world attracts, and that weight falls with height"},
    {"gravity", "tree", "the last digits of the momentum: actions equal reactions only nearly"},
    {"gravity", "real", "relativity: the delay of attraction, and the slower clocks"},
    {"electricity", "single-cable", "that current needs a return path, and how strong it is"},
    {"electricity", "two-wire",
     "how strong a current is: the lamp in a balanced bridge and a shorted lamp are on, and eleven lamps in "
     "series are as bright as one"},
    {"electricity", "flow", "how a current divides between several paths, and so the brightness of lamps"},
    {"electricity", "nodal", "what happens before the current is steady: there are no coils or capacitors"},
    {"magnetism", "grid", "the far field: the sum of many weak forces of distant magnets"},
    {"magnetism", "tree", "the last digits of the momentum: actions equal reactions only nearly"},
    {"magnetism", "pairwise", "that iron is magnetised by iron, and how magnets shape the field of others"},
    {"magnetism", "one pole", "that magnets turn, and that cutting them in two gives two magnets"},
    {"magnetism", "two poles", "how strength is spread over a real magnet's faces"},
    {"buoyancy", "exact", "waves, currents and the rise of the surface when a body is immersed"},
    {"buoyancy", "particles",
     "waves, currents and the rise of the surface; and the exact moment at which a corner is immersed"},
    {"buoyancy", "every", "changes between two computations, beyond the first order"},
    {"sound", "1-mode", "material and form, except by pitch"},
    {"sound", "4-modes", "the higher half of the modes of a bell or a bar"},
    {"sound", "modes", "the bending of sound by the air, and how bodies in touch damp one another"},
    {"co-simulation", "substep", "changes of the other simulation within a frame"},
    {"loudness", "straight", "sound around corners"},
    {"loudness", "around", "echoes"},
}};

} // namespace

std::string whatLevelCannotRepresent(std::string const& effect, std::string const& level) {
    for (Limit const& limit : limits) { // exact names first: "4-modes" must not match the entry "modes"
        if (limit.effect == effect && limit.level == level) {
            return std::string(limit.cannotRepresent);
        }
    }
    for (Limit const& limit : limits) {
        if (limit.effect == effect && level.find(limit.level) != std::string::npos) {
            return std::string(limit.cannotRepresent);
        }
    }
    return "";
}

} // namespace trembler::accuracy
