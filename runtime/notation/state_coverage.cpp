#include "runtime/notation/state_coverage.hpp"

#include <set>

namespace trembler {
namespace {

std::string nameOf(Coverage::Kind kind) {
    switch (kind) {
    case Coverage::Kind::hashed:
        return "hashed";
    case Coverage::Kind::derived:
        return "derived";
    case Coverage::Kind::leftOut:
        return "left out";
    }
    return "";
}

void addSlots(Registry const& registry, ComponentKind kind, std::vector<CoverageLine>& lines) {
    std::set<PropertyInfo const*> seen; // alternatives offer the same
    for (Registration const& component : registry.components()) {
        if (component.info->kind != kind) {
            continue;
        }
        for (PropertyInfo const* offer : component.info->offers) {
            if (seen.insert(offer).second) {
                lines.push_back({std::string(offer->text.name), nameOf(offer->coverage.kind),
                                 std::string(offer->coverage.reason)});
            }
        }
    }
}

} // namespace

std::vector<CoverageLine> stateCoverage(Registry const& registry) {
    std::vector<CoverageLine> lines{
        {"every member of every object property, and which ids are free", "hashed", ""},
        {"every held call, and every call that waits for its resolver's next advance", "hashed", ""},
        {"which components are present, requested detail levels, periods and the next turns", "hashed", ""}};
    for (PropertyInfo const* const info : registry.objectProperties()) {
        if (info->coverage.kind == Coverage::Kind::leftOut) {
            lines.push_back({std::string(info->text.name) + " of objects", nameOf(info->coverage.kind),
                             std::string(info->coverage.reason)});
        }
    }
    addSlots(registry, ComponentKind::resolver, lines);
    addSlots(registry, ComponentKind::dps, lines);
    for (Registration const& component : registry.components()) {
        ComponentInfo const& info = *component.info;
        std::string const what = "what the " + title(info) + " keeps";
        if (info.hashesMemory) {
            lines.push_back({what, "hashed", ""});
        }
        if (info.memory) {
            lines.push_back({info.hashesMemory ? what + " besides" : what, nameOf(info.memory->kind),
                             std::string(info.memory->reason)});
        }
    }
    lines.push_back({"versions, which determine the components that run", "left out",
                     "a component that runs with unchanged inputs computes the same result"});
    lines.push_back({"part definitions, registered components and completions", "left out",
                     "they are constant; the objects made from them are hashed"});
    lines.push_back({"data for observers only: loudspeakers, overlays, the trace", "left out",
                     "nothing in the world reads it"});
    lines.push_back({"threads, measured times and budgets", "left out", "they do not change results"});
    return lines;
}

} // namespace trembler
