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

/// The statement that determines each property, by key.
std::map<std::string_view, Determined> determinedOf(MadeObject const& made) {
    std::map<std::string_view, Determined> all;
    for (StatedProperties const& place : made.stated) {
        for (PropertySet::Entry const& entry : place.set->entries()) {
            if (place.states(*entry.info)) {
                all.insert_or_assign(entry.info->text.key, Determined{&entry, &place});
            }
        }
    }
    std::erase_if(all, [&](auto const& property) {
        auto const basis = all.find(property.second.entry->info->text.madeFor);
        return basis != all.end() && basis->second.place > property.second.place;
    });
    return all;
}

} // namespace

StatedProperties const* MadeObject::determining(PropertyInfo const& info) const {
    auto const found = std::find_if(stated.rbegin(), stated.rend(),
                                    [&](StatedProperties const& place) { return place.states(info); });
    return found == stated.rend() ? nullptr : &*found;
}

std::pair<StatementScope const*, std::string> MadeObject::placeOf(PropertyInfo const& info) const {
    using Form = StatedProperties::Form;
    std::string const key(info.text.key);
    StatedProperties const* place = determining(info);
    bool const inPart = place != nullptr && place->form == Form::part;
    if (inPart && place->scope->document != nullptr) {
        bool const beside = place->scope->document->root().contains(key); // its look
        return {place->scope, pointerTo(beside ? "" : "/properties", key)};
    }
    if (place == nullptr || inPart) { // nowhere, or in a part without a file
        auto const entry = std::find_if(stated.rbegin(), stated.rend(), [](StatedProperties const& other) {
            return other.form != Form::part && other.form != Form::overrides;
        });
        place = entry == stated.rend() ? &stated.front() : &*entry;
    }
    if (place->path.empty() || place->form == Form::placement || key == "joint") {
        return {place->scope, place->path};
    }
    bool const under = place->form == Form::entry && info.text.place == PropertyPlace::properties;
    return {place->scope, pointerTo(under ? place->path + "/properties" : place->path, key)};
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
