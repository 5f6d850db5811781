#include "runtime/level/read/solutions/read_solutions.hpp"

#include "runtime/level/json/limits.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/read/read_area.hpp"
#include "runtime/level/read/solutions/read_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace trembler {
namespace {

constexpr double mostDegrees = 1e6; // about 2800 turns

std::optional<Placement> readPlacement(JsonNode const& node) {
    MemberReader reader(node, "an object {\"part\", \"at\", \"angle_deg\", \"flipped\"}");
    Placement placement;
    placement.path = node.path();
    auto const part = reader.required("part", "the name of a part in the toolbox");
    auto const at = reader.required("at", "a list [x, y] of two numbers, in m");
    auto const angle = reader.optional("angle_deg");
    auto const flipped = reader.optional("flipped");
    reader.finish();
    auto const partName = part ? part->name("the name of a part") : std::nullopt;
    auto const place = at ? at->vector(-farthestPlace, farthestPlace) : std::nullopt;
    auto const turned = angle ? angle->number(-mostDegrees, mostDegrees) : std::optional(0.0);
    auto const mirrored = flipped ? flipped->boolean() : std::optional(false);
    if (!partName || !place || !turned || !mirrored) {
        return std::nullopt;
    }
    placement.part = *partName;
    placement.at = *place;
    placement.angle = radians(*turned);
    placement.flipped = *mirrored;
    return placement;
}

/// The keys of the kinds of inputs, in the order of PlayerInput::Kind.
constexpr std::span<std::string_view const> inputKeys = playerInputNames;

bool readInputBody(MemberReader& reader, JsonNode const& body, RecordedInput& input) {
    auto const readName = [](JsonNode const& node, std::string& to) {
        auto const name = node.name("the name of an object");
        to = name.value_or("");
        return name.has_value();
    };
    switch (input.kind) {
    case PlayerInput::Kind::grab: {
        bool const named = readName(body, input.object);
        auto const at = reader.required("at", "a list [x, y] of two numbers, in m: where it is held");
        auto const place = at ? at->vector(-farthestPlace, farthestPlace) : std::nullopt;
        input.at = place.value_or(Vec2{});
        return named && place;
    }
    case PlayerInput::Kind::move: {
        auto const place = body.vector(-farthestPlace, farthestPlace);
        input.at = place.value_or(Vec2{});
        return place.has_value();
    }
    case PlayerInput::Kind::release:
        if (body.value() != true) {
            body.complainOfType("true");
            return false;
        }
        return true;
    case PlayerInput::Kind::cut:
        if (!body.value().is_array() || body.size() != 2) {
            body.complainOfType("a list of the two objects that the wire connects");
            return false;
        }
        return readName(body.element(0), input.object) && readName(body.element(1), input.other);
    case PlayerInput::Kind::remove:
        return readName(body, input.object);
    }
    return false;
}

std::optional<RecordedInput> readInput(JsonNode const& node) {
    constexpr std::string_view expected =
        "one of \"grab\" (with \"at\"), \"move\", \"release\", \"cut\", \"remove\"";
    MemberReader reader(node, "an object {\"frame\", ...}");
    if (!reader.valid()) {
        return std::nullopt;
    }
    RecordedInput input;
    input.path = node.path();
    auto const frameNode = reader.required("frame", "the number of the frame that sees it, from 1");
    auto const frame = frameNode ? frameNode->integer(1, limits::frames) : std::nullopt;
    std::optional<JsonNode> body;
    std::size_t kinds = 0;
    for (std::size_t kind = 0; kind < inputKeys.size(); ++kind) {
        if (auto const found = reader.optional(std::string(inputKeys[kind]))) {
            body = found;
            input.kind = static_cast<PlayerInput::Kind>(kind);
            ++kinds;
        }
    }
    if (kinds != 1) {
        node.complain(kinds == 0 ? "states no input" : "states several inputs at once",
                      std::string(expected));
        reader.know("at");
        reader.know("hand");
        reader.finish();
        return std::nullopt;
    }
    if (auto const hand = input.kind <= PlayerInput::Kind::release ? reader.optional("hand") : std::nullopt) {
        input.hand = static_cast<int>(hand->integer(0, 1).value_or(0));
    }
    bool const good = readInputBody(reader, *body, input);
    reader.finish();
    if (!good || !frame) {
        return std::nullopt;
    }
    input.frame = static_cast<std::uint64_t>(*frame);
    return input;
}

std::optional<LevelConnection> readWire(JsonNode const& node) {
    if (!node.value().is_array() || node.size() != 2) {
        node.complainOfType("a list of the two objects that the wire connects");
        return std::nullopt;
    }
    auto const a = node.element(0).name("the name of an object");
    auto const b = node.element(1).name("the name of an object");
    if (!a || !b) {
        return std::nullopt;
    }
    return LevelConnection{.a = *a, .b = *b, .path = node.path(), .kind = std::string(playersWire)};
}

} // namespace

std::vector<Placement> readPlacements(JsonNode const& node) {
    std::vector<Placement> placements;
    if (node.isList("a list of placements", limits::placements)) {
        for (std::size_t i = 0; i < node.size(); ++i) {
            if (auto placement = readPlacement(node.element(i))) {
                placements.push_back(std::move(*placement));
            }
        }
    }
    return placements;
}

std::optional<Solution> readSolution(JsonNode const& node) {
    MemberReader reader(node, "an object {\"name\", \"placements\", \"wires\", \"inputs\", \"changes\"}");
    if (!reader.valid()) {
        return std::nullopt;
    }
    Solution solution;
    solution.path = node.path();
    if (auto const name = reader.required("name", "a name")) {
        solution.name = name->name("a name").value_or("");
    }
    if (auto const placements = reader.optional("placements")) {
        solution.placements = readPlacements(*placements);
    }
    if (auto const wires = reader.optional("wires");
        wires && wires->isList("a list of pairs of objects", limits::connections)) {
        for (std::size_t i = 0; i < wires->size(); ++i) {
            if (auto wire = readWire(wires->element(i))) {
                solution.wires.push_back(std::move(*wire));
            }
        }
    }
    if (auto const inputs = reader.optional("inputs");
        inputs && inputs->isList("a list of timed inputs", limits::inputs)) {
        for (std::size_t i = 0; i < inputs->size(); ++i) {
            if (auto input = readInput(inputs->element(i))) {
                solution.inputs.push_back(std::move(*input));
            }
        }
        // Inputs of one frame keep the order of the file: a player can do several things between two frames.
        std::stable_sort(solution.inputs.begin(), solution.inputs.end(),
                         [](RecordedInput const& a, RecordedInput const& b) { return a.frame < b.frame; });
    }
    if (auto const changes = reader.optional("changes")) {
        solution.changes = readChanges(*changes);
    }
    if (auto const expect = reader.optional("expect")) {
        constexpr std::array<std::string_view, 2> names{"solved", "unsolved"};
        solution.solves = expect->choice(names).value_or(0) == 0;
    }
    if (auto const frames = reader.optional("frames")) {
        if (auto const count = frames->integer(1, limits::frames)) {
            solution.frames = static_cast<int>(*count);
        }
    }
    reader.finish();
    return solution;
}

std::vector<Solution> readSolutions(JsonNode const& node) {
    std::vector<Solution> solutions;
    std::set<std::string> names;
    if (!node.isList("a list of recorded solutions", limits::solutions)) {
        return solutions;
    }
    for (std::size_t i = 0; i < node.size(); ++i) {
        auto solution = readSolution(node.element(i));
        if (!solution) {
            continue;
        }
        if (!solution->name.empty() && !names.insert(solution->name).second) {
            node.element(i).complain(fmt::format("there is already a solution named '{}'", solution->name),
                                     "a unique name");
        }
        solutions.push_back(std::move(*solution));
    }
    return solutions;
}

} // namespace trembler
