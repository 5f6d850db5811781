#include "runtime/level/read/solutions/read_changes.hpp"

#include "runtime/level/json/limits.hpp"

#include <algorithm>
#include <optional>

namespace trembler {
namespace {

constexpr std::int64_t longestPeriod = 3600; // the limit of World::setPeriod
constexpr double anyNumber = 1e12;           // the range of a field is checked by the property's description

using Kind = RecordedChange::Kind;

/// Calls f(key, value) for every member; complains unless there is at least one.
template <class F>
void forMembers(JsonNode const& node, std::string_view expected, F&& f) {
    if (!node.isObject(expected)) {
        return;
    }
    if (node.value().empty()) {
        node.complain("changes nothing", std::string(expected));
    }
    for (auto const& [key, value] : node.value().items()) {
        f(key, node.member(key));
    }
}

void readBody(JsonNode const& body, RecordedChange change, std::vector<RecordedChange>& into) {
    auto const add = [&](JsonNode const& where) {
        change.path = where.path();
        into.push_back(change);
    };
    switch (change.kind) {
    case Kind::detail:
        forMembers(body, "an object {\"effect\": \"detail level\"}",
                   [&](auto const& effect, JsonNode const& node) {
                       change.subject = effect;
                       if (auto const level = node.text("a detail level, or \"\" to leave it to the scene")) {
                           change.level = *level;
                           add(node);
                       }
                   });
        return;
    case Kind::period:
        forMembers(body, "an object {\"component\": frames}",
                   [&](auto const& component, JsonNode const& node) {
                       change.subject = component;
                       if (auto const frames = node.integer(1, longestPeriod)) {
                           change.value = static_cast<double>(*frames);
                           add(node);
                       }
                   });
        return;
    case Kind::setting:
        forMembers(body, "an object {\"property of the world\": {\"field\": number}}",
                   [&](auto const& property, JsonNode const& fields) {
                       change.subject = property;
                       forMembers(fields, "an object {\"field\": number}",
                                  [&](auto const& field, JsonNode const& node) {
                                      change.field = field;
                                      if (auto const value = node.number(-anyNumber, anyNumber)) {
                                          change.value = *value;
                                          add(node);
                                      }
                                  });
                   });
        return;
    }
}

void readChange(JsonNode const& node, std::vector<RecordedChange>& into) {
    MemberReader reader(node, "an object {\"frame\", ...}");
    if (!reader.valid()) {
        return;
    }
    auto const frameNode =
        reader.required("frame", "the number of the first frame that it counts for, from 1");
    auto const frame = frameNode ? frameNode->integer(1, limits::frames) : std::nullopt;
    std::optional<JsonNode> body;
    RecordedChange change;
    int kinds = 0;
    for (std::size_t kind = 0; kind < std::size(recordedChangeNames); ++kind) {
        if (auto const found = reader.optional(std::string(recordedChangeNames[kind]))) {
            body = found;
            change.kind = static_cast<Kind>(kind);
            ++kinds;
        }
    }
    if (kinds != 1) {
        node.complain(kinds == 0 ? "states no change" : "states several kinds of changes at once",
                      "one of \"detail\", \"period\", \"setting\"");
    }
    reader.finish();
    if (kinds == 1 && frame) {
        change.frame = static_cast<std::uint64_t>(*frame);
        readBody(*body, change, into);
    }
}

} // namespace

std::vector<RecordedChange> readChanges(JsonNode const& node) {
    std::vector<RecordedChange> changes;
    if (node.isList("a list of timed changes of detail levels, periods and settings", limits::changes)) {
        for (std::size_t i = 0; i < node.size(); ++i) {
            readChange(node.element(i), changes);
        }
    }
    std::stable_sort(changes.begin(), changes.end(),
                     [](RecordedChange const& a, RecordedChange const& b) { return a.frame < b.frame; });
    return changes;
}

} // namespace trembler
