// Which numbers of an object can be plotted, and the card in which the player chooses them.
#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/timeline/probe_words.hpp"
#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

namespace trembler::ui {
namespace {

using namespace render;

// Pixels at UI scale 1.
constexpr float choiceWidth = 300;
constexpr float choiceHeight = 250;

constexpr std::size_t mostFound = 40; ///< rows of a search: no part of a name floods the list

struct Usual {
    Phrase name;
    char const* field;
};

constexpr std::array<Usual, 14> usual{{
    {"Speed", "velocity.length"},
    {"Height", "position.y"},
    {"Place from left to right", "position.x"},
    {"Angle", "rotation"},
    {"Turning speed", "angular_velocity"},
    {"Voltage", "electrical_quantities.potential"},
    {"Current", "electrical_quantities.current"},
    {"Power", "electrical_quantities.power"},
    {"Brightness", "electrical_quantities.brightness"},
    {"Whether it is on", "electrical_state.on"},
    {"Magnet's strength", "magnet.level"},
    {"Magnetic force", "magnetic_force.force.length"},
    {"Buoyancy", "buoyancy_force.force.length"},
    {"Loudness", "loudness.level"},
}};

} // namespace

// "coil.electrical_quantities.current" as "coil: Current"; others with the field as it is called.
std::string plotLabel(std::string const& what) {
    for (Usual const& each : usual) {
        std::string const end = std::string(".") + each.field;
        if (what.size() > end.size() && what.ends_with(end)) {
            return shownName(what.substr(0, what.size() - end.size())) + ": " + each.name;
        }
    }
    return what;
}

std::vector<Quantity> ProbePanel::quantitiesOf(World const& world, std::string const& object) const {
    std::vector<Quantity> all;
    std::set<std::string> known;
    auto const hasNumber = [&](watch::Watch const& watch) {
        auto const cells = watch.read(world);
        return std::any_of(cells.begin(), cells.end(),
                           [](watch::Cell const& cell) { return std::holds_alternative<double>(cell); });
    };
    for (Usual const& each : usual) {
        std::string const what = object + "." + each.field;
        try {
            if (hasNumber(watch::find(world, fields_, what))) {
                all.push_back({each.name, what});
                known.insert(what);
            }
        } catch (std::invalid_argument const&) {
            continue; // the object does not have it
        }
    }
    for (watch::WatchedField const& field : fields_) {
        std::string const what = object + "." + field.spokenName();
        bool const numbers = field.type != FieldType::text && field.type != FieldType::object &&
                             field.type != FieldType::choice && field.type != FieldType::list;
        if (numbers && !field.ofWorld() && !field.numbered() && known.count(what) == 0 &&
            hasNumber({what, object, field})) {
            all.push_back({field.spokenName(), what});
        }
    }
    return all;
}

watch::NamedNumbers ProbePanel::quantitiesNamed(World const& world, std::string const& object) const {
    return watch::namedNumbers(world, fields_, object, word_.data(), mostFound);
}

void ProbePanel::drawBox(Layout& layout, World const& world, std::string const& name,
                         std::string const& what) {
    bool on = probes_.has(what);
    if (render::checkBox((name + "##" + what).c_str(), &on)) {
        toggle(world, what);
    }
    layout.item("plot " + what);
}

void ProbePanel::drawQuantities(Layout& layout, World const& world, std::string const& object) {
    for (Quantity const& quantity : quantitiesOf(world, object)) {
        drawBox(layout, world, quantity.name, quantity.what);
    }
}

void ProbePanel::drawFound(Layout& layout, World const& world, std::string const& object) {
    watch::NamedNumbers const named = quantitiesNamed(world, object);
    for (std::string const& what : named.found) {
        drawBox(layout, world, what, what);
    }
    if (named.more > 0) {
        caption(textWith("{} more: a longer word finds fewer.", named.more).c_str());
    } else if (named.found.empty()) {
        caption(named.similar.empty() ? text("No number has such a name.")
                                      : text("No number has such a name; similar:"));
        for (std::string const& what : named.similar) {
            if (ImGui::Selectable(what.c_str())) {
                word_.fill('\0');
                std::copy_n(what.begin(), std::min(what.size(), word_.size() - 1), word_.begin());
            }
            layout.item("similar " + what);
        }
    }
}

std::string ProbePanel::drawChoice(Layout& layout, World const& world, std::string const& object,
                                   float above) {
    findFields();
    std::string wanted;
    layout.beginCard("probe choice", text("Plot"),
                     {.anchor = Anchor::BottomLeft, .offset = {cardGap, above}, .width = choiceWidth});
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##word", text("Find a number by its name"), word_.data(), word_.size());
    layout.item("find a number");
    bool const typed = word_.front() != '\0';
    if (object.empty() && !typed) {
        caption(text("Click on an object: then its numbers are listed here."));
    } else {
        if (!object.empty()) {
            ImGui::PushFont(theme().fonts.strong);
            ImGui::TextUnformatted(shownName(object).c_str());
            ImGui::PopFont();
        }
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("quantities", {0, scaled(choiceHeight - 110)});
        if (typed) {
            drawFound(layout, world, object);
        } else {
            drawQuantities(layout, world, object);
        }
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    if (!probes_.watches().empty()) {
        for (char const* const ending : {".csv", ".svg"}) {
            if (bigButton(ending + 1, {.width = 76})) {
                wanted = ending;
            }
            layout.item(std::string("save ") + (ending + 1));
            ImGui::SameLine();
        }
        if (bigButton(text("Remove all"), {.width = 100})) {
            removeAll();
        }
        layout.item("remove probes");
    }
    layout.endCard();
    return wanted;
}

} // namespace trembler::ui
