#include "puzzle/goals/words/lamp.hpp"

#include "physics/electricity/properties/electrical.hpp"
#include "physics/material.hpp"

namespace trembler {
namespace {

template <class P>
P const* statedIn(Prototype const& part) {
    for (std::unique_ptr<PropertyValue> const& value : part.values) {
        if (value != nullptr && value->info().type == propertyInfo<P>().type) {
            return &static_cast<ValueOf<P> const&>(*value).value;
        }
    }
    return nullptr;
}

bool isLampOf(ElectricalDevice const* device, MadeOf const* madeOf) {
    return device != nullptr && madeOf != nullptr && madeOf->material == Material::glass;
}

} // namespace

bool isLamp(World const& world, ObjectId id) {
    return isLampOf(world.find<ElectricalDevice>(id), world.find<MadeOf>(id));
}

bool isLamp(Prototype const& part) {
    return isLampOf(statedIn<ElectricalDevice>(part), statedIn<MadeOf>(part));
}

} // namespace trembler
