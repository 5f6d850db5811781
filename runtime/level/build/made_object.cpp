#include "runtime/level/build/made_object.hpp"

#include "runtime/level/property/move_property.hpp"

#include <algorithm>
#include <map>

namespace trembler {
namespace {

struct Determined {
    PropertySet::Entry const* entry;
    StatedProperties const* place;
};

/// What determines each property, by key.
std::map<std::string_view, Determined> determinedOf(MadeObject const& made) {
    std::map<std::string_view, Determined> all;
    for (StatedProperties const& place : made.stated) {
        for (PropertySet::Entry const& entry : place.set->entries()) {
            if (place.states(*entry.info)) {
                all.insert_or_assign(entry.info->text.key, Determined{&entry, &place});
            }
        }
    }
    return all;
}

} // namespace

StatedProperties const* MadeObject::determining(PropertyInfo const& info) const {
    auto const found = std::find_if(stated.rbegin(), stated.rend(),
                                    [&](StatedProperties const& place) { return place.states(info); });
    return found == stated.rend() ? nullptr : &*found;
}

PropertySet MadeObject::properties() const {
    PropertySet all;
    for (auto const& [key, determined] : determinedOf(*this)) {
        if (!determined.entry->value) {
            continue;
        }
        auto value = determined.entry->value->clone();
        PieceFrame const& frame = determined.place->frame;
        bool const mirror = flipped != frame.flipped;
        if (mirror || frame != PieceFrame{}) {
            moveProperty(*value, frame, mirror);
        }
        all.set(std::move(value));
    }
    return all;
}

std::vector<std::string> MadeObject::without() const {
    std::vector<std::string> keys;
    for (auto const& [key, determined] : determinedOf(*this)) {
        if (!determined.entry->value) {
            keys.emplace_back(key);
        }
    }
    return keys;
}

} // namespace trembler
