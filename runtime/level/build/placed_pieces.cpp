#include "runtime/level/build/placed_pieces.hpp"

#include "runtime/level/build/part_expander.hpp"
#include "runtime/placement.hpp"

#include <utility>

namespace trembler {

LevelObject entryOf(Placement const& placement, std::string name) {
    LevelObject entry;
    entry.name = std::move(name);
    entry.part = placement.part;
    entry.properties.set(Position{placement.at});
    entry.properties.set(Rotation{placement.angle});
    entry.path = placement.path;
    entry.flipped = placement.flipped;
    return entry;
}

EntryNames namesOf(PartLibrary const& library, LevelObject const& entry) {
    PartDefinition const* const part = library.find(entry.part);
    if (part == nullptr || part->objects.empty()) {
        return {{entry.name}, 0};
    }
    PartExpander expander(library, [](auto const&...) {});
    StatementScope const nowhere;
    ExpandedEntry const expanded = expander.expand(entry, nowhere);
    EntryNames names{{}, expanded.main};
    for (MadeObject const& made : expanded.objects) {
        names.objects.push_back(made.name);
    }
    return names;
}

std::vector<PlacedPiece> placedPieces(PartLibrary const& library, Placement const& placement) {
    bool whole = true;
    PartExpander expander(library, [&](auto const&...) { whole = false; });
    LevelObject const entry = entryOf(placement, placement.part);
    StatementScope const nowhere;
    ExpandedEntry const expanded = expander.expand(entry, nowhere, StatedProperties::Form::placement);
    std::vector<PlacedPiece> pieces;
    for (std::size_t i = 0; whole && i < expanded.objects.size(); ++i) {
        MadeObject const& made = expanded.objects[i];
        if (!made.joint) {
            std::size_t const own = expanded.aliases.empty() ? 0 : entry.name.size() + 1;
            pieces.push_back(
                {made.name.substr(made.name.size() > own ? own : 0), made.properties(), i == expanded.main});
        }
    }
    return pieces;
}

} // namespace trembler
