// Complains about materials that say something else than the object is: see level_checks.hpp.
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/drawing.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/look.hpp"
#include "physics/look_form.hpp"
#include "physics/material.hpp"
#include "puzzle/checks/level_checks.hpp"
#include "runtime/level/build/placed_pieces.hpp"
#include "runtime/level/json/add_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace trembler {
namespace {

/// A body of it is one only if it states Liquid.
bool isLiquid(Material material) {
    return material == Material::water;
}

struct Mismatch {
    std::string_view message; ///< behind the object's name
    std::string_view expected;
};

/// `find` gives the property of the object of a type, or null.
template <class Find>
std::optional<Mismatch> mismatchOf(Find const& find) {
    MadeOf const* const of = find.template operator()<MadeOf>();
    if (of == nullptr || find.template operator()<Shape>() == nullptr) {
        return std::nullopt;
    }
    bool const ownAppearance = find.template operator()<Look>() != nullptr ||
                               find.template operator()<Drawing>() != nullptr ||
                               find.template operator()<DrawnAs>() != nullptr;
    bool const liquid = find.template operator()<Liquid>() != nullptr;
    if (liquid == isLiquid(of->material) || ownAppearance) {
        return std::nullopt;
    }
    return liquid
               ? Mismatch{"is a body of liquid, but its material is a solid one, which it looks like",
                          "\"material\": \"water\", or no material, with the liquid's \"density\""}
               : Mismatch{"is a solid body, but its material is water, which it only looks like: nothing "
                          "floats or sinks in it",
                          "\"liquid\": true as well for a body of water, or a solid material; a solid that "
                          "is to look so states its \"look\" or \"drawing\""};
}

std::optional<Mismatch> mismatchOf(PropertySet const& properties) {
    return mismatchOf([&]<class Property>() { return properties.find<Property>(); });
}

} // namespace

void complainAboutMatter(PartLibrary const& parts, LevelFile const& level, BuiltLevel const& built,
                         Problems& problems) {
    auto const complain = [&](std::string const& path, std::string const& name, Mismatch const& mismatch) {
        addProblem(problems, [&] {
            return level.diagnostic(path, fmt::format("'{}' {}", name, mismatch.message),
                                    std::string(mismatch.expected));
        });
    };
    World const& world = *built.world;
    for (std::size_t i = 0; i < level.objects.size(); ++i) {
        LevelObject const& object = level.objects[i];
        auto const pieces = built.objectPieces.find(i);
        std::vector<ObjectId> const ids =
            pieces == built.objectPieces.end() ? std::vector{built.objects[i]} : pieces->second;
        for (ObjectId const id : ids) {
            if (auto const mismatch =
                    mismatchOf([&]<class Property>() { return world.find<Property>(id); })) {
                bool const here = object.properties.find<MadeOf>() != nullptr && !object.path.empty();
                complain(here ? object.path + "/properties/material" : object.path, world.store().nameOf(id),
                         *mismatch);
            }
        }
    }
    for (ToolboxEntry const& entry : level.toolbox) {
        PartDefinition const* const part = parts.find(entry.part);
        if (part == nullptr) {
            continue;
        }
        Placement placement;
        placement.part = entry.part;
        for (PlacedPiece const& piece : placedPieces(parts, placement)) { // with those of parts inside it
            if (auto const mismatch = mismatchOf(piece.properties)) {
                complain(entry.path,
                         part->composite() ? fmt::format("{}' of '{}", piece.name, entry.part) : entry.part,
                         *mismatch);
            }
        }
    }
}

} // namespace trembler
