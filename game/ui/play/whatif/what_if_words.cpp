#include "game/ui/play/whatif/what_if_words.hpp"

#include "game/ui/panels/inspector.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"

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
    for (ColumnBase const* const column : world.store().columns()) {
        if (column->info().text.key == change.property) {
            property = translated(std::string(column->info().text.name));
        }
    }
    std::string const of = change.field == "value" ? property : property + ", " + spokenField(change.field);
    return name + ": " + of + " = " + readable(change.amount.x);
}

} // namespace trembler::ui
