#include "game/ui/play/whatif/what_if_words.hpp"

#include "game/ui/shared/readable_number.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "insight/whatif/settable.hpp"

#include <algorithm>
#include <string_view>

namespace trembler::ui {

std::string spokenField(std::string const& key) {
    std::string spoken = key;
    if (spoken.ends_with("_deg")) {
        spoken.resize(spoken.size() - std::string_view("_deg").size());
    }
    std::replace(spoken.begin(), spoken.end(), '_', ' ');
    return translated(spoken);
}

namespace {

/// The amount as the widget that sets it shows it.
std::string amountInWords(insight::SettableField const& field, insight::FieldAmount const& amount) {
    if (field.type == FieldType::boolean) {
        return text(amount.x != 0 ? "on" : "off");
    }
    if (auto const choice = static_cast<std::size_t>(amount.x); field.type == FieldType::choice) {
        return choice < field.choices.size() ? spokenField(std::string(field.choices[choice])) : "";
    }
    bool const turned = field.unit.starts_with("rad");
    double const scale = turned ? 180 / pi : 1;
    std::string words = readable(amount.x * scale);
    if (field.type == FieldType::vector) {
        words = "(" + words + "; " + readable(amount.y * scale) + ")";
    }
    return words + (turned ? "°" + field.unit.substr(3) : field.unit.empty() ? "" : " " + field.unit);
}

} // namespace

std::string wordsOf(insight::Change const& change, World const& world) {
    using Kind = insight::Change::Kind;
    std::string const name = shownName(change.object);
    switch (change.kind) {
    case Kind::place:
        return textWith("{}: moved", name);
    case Kind::remove:
        return textWith("{}: removed", name);
    case Kind::cut:
        return textWith("{}, {}: wire cut", name, shownName(change.other));
    case Kind::grab:
        return textWith("{}: pulled", name);
    case Kind::input:
        return text("Without what the hand does then");
    case Kind::interaction:
        return textWith("Without {}", translated(change.object));
    case Kind::field:
        break;
    }
    std::string property = spokenField(change.property);
    std::string amount = readable(change.amount.x); // of an object that no longer exists
    for (insight::SettableField const& field :
         insight::settableFields(world, world.store().find(change.object))) {
        if (field.property->text.key == change.property) {
            property = translated(std::string(field.property->text.name));
            amount = field.key == change.field ? amountInWords(field, change.amount) : amount;
        }
    }
    std::string const of = change.field == "value" ? property : property + ", " + spokenField(change.field);
    return name + ": " + of + " = " + amount;
}

} // namespace trembler::ui
