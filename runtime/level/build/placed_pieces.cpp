#include "runtime/level/build/placed_pieces.hpp"

#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/build/references.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <utility>

namespace trembler {
namespace {

/// Calls `use` with the objects that a placement becomes, unless its pieces cannot be made.
template <class Use>
void withObjectsOf(PartLibrary const& library, Placement const& placement, Use const& use) {
    bool whole = true;
    PartExpander expander(library, [&](auto const&...) { whole = false; });
    LevelObject const entry = entryOf(placement, placement.part);
    StatementScope const nowhere;
    ExpandedEntry const expanded = expander.expand(entry, nowhere, StatedProperties::Form::placement);
    if (whole) {
        use(expanded);
    }
}

} // namespace

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
    std::vector<PlacedPiece> pieces;
    withObjectsOf(library, placement, [&](ExpandedEntry const& expanded) {
        std::size_t const own = expanded.aliases.empty() ? 0 : placement.part.size() + 1;
        for (std::size_t i = 0; i < expanded.objects.size(); ++i) {
            MadeObject const& made = expanded.objects[i];
            if (!made.joint) {
                pieces.push_back({made.name.substr(made.name.size() > own ? own : 0), made.properties(),
                                  i == expanded.main});
            }
        }
    });
    return pieces;
}

std::vector<PropertySet> placedJoints(PartLibrary const& library, Placement const& placement) {
    std::vector<PropertySet> joints;
    withObjectsOf(library, placement, [&](ExpandedEntry const& expanded) {
        Store names; // only to resolve references, as in a world
        std::vector<ObjectId> ids;
        for (std::size_t i = 0; i < expanded.objects.size(); ++i) {
            ids.push_back(names.create(fmt::format("/{}", i))); // unique, whatever the part's file says
        }
        for (std::size_t i = 0; i < expanded.objects.size(); ++i) {
            names.alias(expanded.objects[i].name, ids[i]);
        }
        for (auto const& [alias, name] : expanded.aliases) {
            names.alias(alias, names.find(name));
        }
        for (MadeObject const& made : expanded.objects) {
            if (made.joint) {
                PropertySet properties = made.properties();
                for (PropertySet::Entry const& entry : properties.entries()) {
                    StatementScope const& scope = *made.determining(*entry.info)->scope;
                    static_cast<void>(resolveReferences(*entry.value, *scope.names, names, scope.prefix));
                }
                joints.push_back(std::move(properties));
            }
        }
    });
    return joints;
}

} // namespace trembler
