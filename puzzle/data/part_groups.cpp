#include "puzzle/data/part_groups.hpp"

#include "audio/effect/properties/acoustics.hpp"
#include "lua/attach/scripts_property.hpp"
#include "physics/buoyancy/properties/air.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/material.hpp"
#include "physics/motor/properties.hpp"
#include "runtime/level/json/limits.hpp"

#include <algorithm>

namespace trembler {
namespace {

/// Of foam, thin walls or gas, kg/m³; the lightest wood of the parts has 240.
constexpr double lightDensity = 200;

/// What a part has, in whichever of its pieces.
struct Traits {
    bool drives = false; ///< a motor or a generator
    bool device = false; ///< it takes current or supplies it
    bool copper = false;
    bool magnet = false;
    bool moving = false; ///< joints by which pieces move
    bool light = false;
    bool wet = false;
    bool sounds = false;
    bool scripts = false;
    bool fixed = false; ///< the main piece
    bool single = true; ///< one object
};

template <ObjectProperty P>
P const* propertyOf(PropertySet const& own, PropertySet const* inherited) {
    if (own.states(propertyInfo<P>()) || inherited == nullptr) {
        return own.find<P>();
    }
    return inherited->find<P>();
}

/// Adds what one object has: its own properties, and those of the part that it is made from.
void addObject(Traits& traits, PropertySet const& own, PropertySet const* inherited, bool main) {
    auto const has = [&]<ObjectProperty... P>() {
        return ((propertyOf<P>(own, inherited) != nullptr) || ...);
    };
    traits.drives = traits.drives || has.operator()<ElectricMotor, Generator>();
    traits.device = traits.device || has.operator()<ElectricalSource, ElectricalReturn, ElectricalDevice, Emf,
                                                    Fuse, ElectricMotor, Generator>();
    traits.magnet = traits.magnet || has.operator()<Magnet, Electromagnet, MagneticPoles>();
    traits.wet = traits.wet || has.operator()<Liquid, InAir>();
    traits.sounds = traits.sounds || has.operator()<Acoustics, SoundSensor>();
    traits.scripts = traits.scripts || has.operator()<lua::Scripts>();
    auto const* const material = propertyOf<MadeOf>(own, inherited);
    traits.copper = traits.copper || (material != nullptr && material->material == Material::copper);
    auto const* const density = propertyOf<Density>(own, inherited);
    traits.light = traits.light || (density != nullptr && density->value <= lightDensity);
    traits.fixed = traits.fixed || (main && has.operator()<Fixed>());
}

void addPart(Traits& traits, PartLibrary const& parts, PartDefinition const& part, bool main,
             std::size_t depth) {
    if (!part.composite()) {
        addObject(traits, part.properties, nullptr, main);
        return;
    }
    traits.single = false;
    for (LevelObject const& piece : part.objects) {
        PartDefinition const* const made = piece.part.empty() ? nullptr : parts.find(piece.part);
        bool const isMain = main && piece.name == part.mainPiece();
        if (made != nullptr && made->composite() && depth < limits::partDepth) {
            addPart(traits, parts, *made, isMain, depth + 1);
        }
        bool const inherits = made != nullptr && !made->composite();
        addObject(traits, piece.properties, inherits ? &made->properties : nullptr, isMain);
        if (isMain) {
            addObject(traits, part.properties, nullptr, true);
        }
    }
    for (LevelJoint const& joint : part.joints) {
        auto const* const stated = joint.properties.find<Joint>();
        traits.moving = traits.moving || (stated != nullptr && stated->form != JointForm::weld);
    }
}

} // namespace

std::vector<PartGroup> groupsOf(PartLibrary const& parts, std::string const& part) {
    PartDefinition const* const found = parts.find(part);
    if (found == nullptr) {
        return {};
    }
    std::vector<PartGroup> groups;
    if (found->groups && !found->groups->empty()) {
        groups = *found->groups;
        std::sort(groups.begin(), groups.end());
        return groups;
    }
    Traits traits;
    addPart(traits, parts, *found, true, 0);
    auto const add = [&](bool belongs, PartGroup group) {
        if (belongs) {
            groups.push_back(group);
        }
    };
    bool const electric = traits.device || traits.copper;
    bool const magnetic = traits.magnet && !traits.sounds;
    add(electric, PartGroup::electricity);
    add(magnetic, PartGroup::magnets);
    add(traits.moving && (traits.drives || !(electric || magnetic)), PartGroup::mechanics);
    add(traits.wet || traits.light, PartGroup::water);
    add(traits.sounds, PartGroup::sound);
    add(groups.empty() && traits.fixed && !traits.scripts, PartGroup::structures);
    bool const functions = traits.device || magnetic || traits.sounds || traits.scripts;
    add(traits.single && !traits.fixed && !functions, PartGroup::solids);
    add(traits.scripts, PartGroup::mods);
    if (groups.empty()) {
        groups.push_back(PartGroup::solids);
    }
    return groups;
}

} // namespace trembler
