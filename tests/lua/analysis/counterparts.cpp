#include "tests/lua/analysis/counterparts.hpp"

#include <fstream>
#include <stdexcept>
#include <string_view>

namespace trembler::lua::analysis {
namespace {

std::filesystem::path const sources = TREMBLER_SOURCE_DIR;

std::vector<std::string> linesOf(std::filesystem::path const& path) {
    std::ifstream file(path);
    if (!file) {
        throw std::runtime_error("cannot read " + path.string());
    }
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
        lines.push_back(line);
    }
    return lines;
}

bool isCode(std::string const& line, std::string_view comment) {
    std::size_t const at = line.find_first_not_of(" \t");
    return at != std::string::npos && !std::string_view(line).substr(at).starts_with(comment);
}

} // namespace

std::vector<Counterpart> counterparts() {
    std::filesystem::path const scripts = sources / "tests/lua/analysis/interactions";
    auto const of = [&](std::string name, std::string className, std::vector<std::filesystem::path> files,
                        std::string const& script, std::string remark = "") {
        return Counterpart{.name = std::move(name),
                           .className = std::move(className),
                           .nativeFiles = std::move(files),
                           .script = script.empty() ? std::filesystem::path() : scripts / (script + ".lua"),
                           .remark = std::move(remark)};
    };
    std::string const dynamics = "physics/dynamics/interactions/";
    std::string const electricity = "physics/electricity/interactions/";
    std::string const sound = "audio/effect/interactions/";
    return {
        of("Population <- Player", "PopulationFromPlayer",
           {"runtime/population/population_resolver.hpp", "runtime/population/population_resolver.cpp"},
           "population_from_player"),
        of("Dynamics <- Player", "DynamicsFromPlayer",
           {dynamics + "from_player.hpp", dynamics + "from_player.cpp"}, "dynamics_from_player",
           "masses and moments of shapes are a library in C++, 50 lines in Lua"),
        of("Frame <- Dynamics", "FrameFromDynamics", {dynamics + "frame_from_dynamics.hpp"},
           "frame_from_dynamics"),
        of("Population <- Dynamics", "PopulationFromDynamics",
           {dynamics + "population_from_dynamics.hpp", dynamics + "population_from_dynamics.cpp"},
           "population_from_dynamics"),
        of("Electricity <- Dynamics", "ElectricityFromDynamics",
           {electricity + "from_dynamics.hpp", electricity + "from_dynamics.cpp"},
           "electricity_from_dynamics", "goes by contacts that begin and end, as no list of pairs lasts"),
        of("Electricity <- Player", "ElectricityFromPlayer", {electricity + "from_player.hpp"},
           "electricity_from_player"),
        of("Electricity <- Fuses", "ElectricityFromFuses",
           {electricity + "from_fuses.hpp", electricity + "from_fuses.cpp"}, "electricity_from_fuses"),
        of("Dynamics <- Gravity", "DynamicsFromGravity", {dynamics + "from_gravity.hpp"},
           "dynamics_from_gravity"),
        of("Magnetics <- Electricity", "MagneticsFromElectricity", {"physics/magnetism/from_electricity.hpp"},
           "magnetics_from_electricity"),
        of("Dynamics <- Magnetic Forces", "DynamicsFromMagneticForces", {dynamics + "from_magnetism.hpp"},
           "dynamics_from_magnetic_forces"),
        of("Frame <- Magnetic Forces", "FrameFromMagneticForces",
           {"physics/magnetism/frame_from_magnetism.hpp"}, "frame_from_magnetic_forces"),
        of("Electricity <- Rotation", "ElectricityFromRotation",
           {"physics/motor/electricity_from_rotation.hpp", "physics/motor/electricity_from_rotation.cpp"},
           "electricity_from_rotation",
           "keeps itself what it has connected, as no script knows its own connections in the graph"),
        of("Dynamics <- Electricity", "DynamicsFromElectricity",
           {"physics/motor/dynamics_from_motors.hpp", "physics/motor/dynamics_from_motors.cpp"},
           "dynamics_from_electricity", "masses and moments as above"),
        of("Dynamics <- Generators", "DynamicsFromGenerators",
           {"physics/motor/dynamics_from_motors.hpp", "physics/motor/dynamics_from_motors.cpp"},
           "dynamics_from_generators", "masses and moments as above"),
        of("Buoyancy <- Gravity", "BuoyancyFromGravity", {"physics/buoyancy/interactions/from_gravity.hpp"},
           "buoyancy_from_gravity", "no script can ask for its turn in the setup; the harness grants it"),
        of("Dynamics <- Buoyancy", "DynamicsFromBuoyancy", {dynamics + "from_buoyancy.hpp"},
           "dynamics_from_buoyancy"),
        of("Dynamics <- Liquid Drag", "DynamicsFromLiquidDrag", {dynamics + "from_liquid_drag.hpp"},
           "dynamics_from_liquid_drag"),
        of("Sound <- Dynamics", "SoundFromDynamics",
           {sound + "from_dynamics.hpp", sound + "from_dynamics.cpp"}, "sound_from_dynamics",
           "where a body is turned, the last bit of a sine or cosine: those of scripts are the same on every "
           "machine, those of C++ are the C library's"),
        of("Sound <- Buoyancy", "SoundFromBuoyancy",
           {sound + "from_buoyancy.hpp", sound + "from_buoyancy.cpp"}, "sound_from_buoyancy",
           "one liquid at a time, as nothing lasts for a pair of objects"),
        of("Sound <- Electricity", "SoundFromElectricity", {sound + "from_electricity.hpp"},
           "sound_from_electricity"),
        of("Electricity <- Sound", "ElectricityFromSound",
           {sound + "electricity_from_sound.hpp", sound + "electricity_from_sound.cpp"},
           "electricity_from_sound",
           "finds out from contacts what it has connected, as no list of pairs lasts"),
    };
}

int nativeLines(Counterpart const& counterpart) {
    int count = 0;
    for (std::filesystem::path const& file : counterpart.nativeFiles) {
        bool inside = false;
        for (std::string const& line : linesOf(sources / file)) {
            bool const begins =
                line.starts_with("class " + counterpart.className + " ") || line.starts_with("namespace {") ||
                (!line.starts_with(" ") && line.find(counterpart.className + "::") != std::string::npos);
            inside = inside || begins;
            count += inside && isCode(line, "//") && !line.starts_with("namespace {") &&
                             !line.starts_with("} // namespace")
                         ? 1
                         : 0;
            if (line.starts_with("}") && !line.starts_with("} // namespace trembler")) {
                inside = inside && line != "}" && line != "};" && !line.starts_with("} // namespace");
            }
        }
    }
    return count;
}

int scriptLines(Counterpart const& counterpart) {
    int count = 0;
    if (!counterpart.script.empty()) {
        for (std::string const& line : linesOf(counterpart.script)) {
            count += isCode(line, "--") ? 1 : 0;
        }
    }
    return count;
}

} // namespace trembler::lua::analysis
