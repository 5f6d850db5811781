#include "insight/trial/solution_text.hpp"

#include "insight/trial/text_hash.hpp"
#include "runtime/level/build/placing.hpp"
#include "runtime/level/write/write_level.hpp"

#include <nlohmann/json.hpp>

namespace trembler::insight {

std::string toText(Solution const& solution) {
    nlohmann::json placements = nlohmann::json::array();
    for (Placement const& p : inCanonicalOrder(solution.placements)) {
        placements.push_back({p.part, p.at.x, p.at.y, p.angle, p.flipped});
    }
    nlohmann::json wires = nlohmann::json::array();
    for (LevelConnection const& wire : solution.wires) {
        wires.push_back({wire.a, wire.b, wire.kind});
    }
    nlohmann::json inputs = nlohmann::json::array();
    for (RecordedInput const& in : solution.inputs) {
        inputs.push_back(
            {in.frame, static_cast<int>(in.kind), in.object, in.other, in.at.x, in.at.y, in.hand});
    }
    return nlohmann::json{placements, wires, inputs}.dump();
}

Solution solutionFrom(std::string const& text) {
    nlohmann::json const all = nlohmann::json::parse(text);
    Solution solution;
    for (auto const& p : all.at(0)) {
        Placement placement;
        placement.part = p.at(0).get<std::string>();
        placement.at = {p.at(1).get<double>(), p.at(2).get<double>()};
        placement.angle = p.at(3).get<double>();
        placement.flipped = p.at(4).get<bool>();
        solution.placements.push_back(placement);
    }
    for (auto const& w : all.at(1)) {
        solution.wires.push_back(
            {w.at(0).get<std::string>(), w.at(1).get<std::string>(), "", w.at(2).get<std::string>()});
    }
    for (auto const& in : all.at(2)) {
        RecordedInput input;
        input.frame = in.at(0).get<std::uint64_t>();
        input.kind = static_cast<PlayerInput::Kind>(in.at(1).get<int>());
        input.object = in.at(2).get<std::string>();
        input.other = in.at(3).get<std::string>();
        input.at = {in.at(4).get<double>(), in.at(5).get<double>()};
        input.hand = in.at(6).get<int>();
        solution.inputs.push_back(input);
    }
    return solution;
}

std::string identityOf(Solution const& solution) {
    Solution rest; // the entries that the line of text leaves out
    rest.changes = solution.changes;
    rest.frames = solution.frames;
    std::string const text = toText(solution) + writeSolution(rest).dump();
    return hashOf(text);
}

} // namespace trembler::insight
