#include "game/session/solution_file.hpp"

#include "runtime/level/read_solutions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <stdexcept>

namespace trembler {

Solution findOrLoadSolution(Registry const&, LevelFile const& level, std::string const& nameOrFile) {
    if (Solution const* const known = level.findSolution(nameOrFile)) {
        return *known;
    }
    std::error_code error;
    if (!std::filesystem::exists(nameOrFile, error)) {
        std::string names;
        for (Solution const& solution : level.solutions) {
            names += (names.empty() ? "'" : ", '") + solution.name + "'";
        }
        throw std::invalid_argument(
            fmt::format("there is neither a file nor a recorded solution '{}'; the level's solutions are: {}",
                        nameOrFile, names.empty() ? "none" : names));
    }
    auto const document = JsonDocument::load(nameOrFile);
    Problems problems;
    std::optional<Solution> solution = readSolution(JsonNode(*document, document->root(), "", problems));
    problems.throwIfAny();
    return solution.value_or(Solution{});
}

nlohmann::ordered_json toJson(Solution const& solution) {
    using Json = nlohmann::ordered_json;
    Json json{{"name", solution.name}};
    if (!solution.solves) {
        json["expect"] = "unsolved";
    }
    if (solution.frames) {
        json["frames"] = *solution.frames;
    }
    json["placements"] = Json::array();
    for (Placement const& placement : solution.placements) {
        json["placements"].push_back({{"part", placement.part},
                                      {"at", {placement.at.x, placement.at.y}},
                                      {"angle_deg", placement.angle * 180 / pi}});
    }
    json["inputs"] = Json::array();
    for (RecordedInput const& input : solution.inputs) {
        Json entry{{"frame", input.frame}};
        switch (input.kind) {
        case PlayerInput::Kind::grab:
            entry["grab"] = input.object;
            entry["at"] = {input.at.x, input.at.y};
            break;
        case PlayerInput::Kind::move:
            entry["move"] = {input.at.x, input.at.y};
            break;
        case PlayerInput::Kind::release:
            entry["release"] = true;
            break;
        case PlayerInput::Kind::cut:
            entry["cut"] = {input.object, input.other};
            break;
        case PlayerInput::Kind::remove:
            entry["remove"] = input.object;
            break;
        }
        json["inputs"].push_back(entry);
    }
    return json;
}

} // namespace trembler
