#include "game/ui/edit/panels/palette_entries.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/fields/field_widgets.hpp"
#include "game/ui/shared/words.hpp"
#include "physics/dynamics/properties/joint.hpp"

namespace trembler::ui {

std::vector<PaletteEntry> partsAndJoints(EditParts const& parts) {
    std::vector<PaletteEntry> all;
    if (parts.document.readOnly()) {
        return all;
    }
    for (std::string const& part : parts.data->parts.names()) {
        all.push_back({.kind = PaletteEntry::Kind::part,
                       .id = part,
                       .name = parts.dataParts->titleOf(part),
                       .kindInWords = words::partField,
                       .tip = parts.dataParts->textOf(part)});
    }
    for (std::string_view const form : choiceNames<JointForm>) {
        all.push_back({.kind = PaletteEntry::Kind::joint,
                       .id = std::string(form),
                       .name = words::capital(shownChoice(std::string(form))),
                       .kindInWords = words::jointKind,
                       .tip = {}});
    }
    return all;
}

void takeFound(EditParts& parts, PaletteEntry const& entry) {
    bool const part = entry.kind == PaletteEntry::Kind::part;
    parts.partInHand = part ? entry.id : std::string();
    parts.tool = part ? Tool::select : Tool::joint;
    parts.jointForm = part ? parts.jointForm : entry.id;
}

} // namespace trembler::ui
