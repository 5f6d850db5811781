#include "game/ui/play/whatif/what_if_card.hpp"

#include "game/ui/play/whatif/what_if_fields.hpp"
#include "game/ui/play/whatif/what_if_words.hpp"
#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"
#include "runtime/component/info.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace trembler::ui {
namespace {

using namespace render;
using insight::Change;

// Pixels at UI scale 1.
constexpr float whatIfWidth = 300;
constexpr float whatIfList = 132; ///< height of the list that scrolls, if there is room
constexpr float leastList = 64;
constexpr float whatIfRest = 206; ///< height of the rest of the card, and a gap

std::string secondsAt(std::uint64_t frame) {
    return textWith("{:.2Lf} s", static_cast<double>(frame) / 60);
}

/// The interactions that are at work, or would be.
std::vector<std::string> interactionsOf(Session const& session) {
    std::vector<std::string> all;
    for (ComponentStatus const& status : session.world().status()) {
        if (status.info->kind == ComponentKind::interaction && status.activity != Activity::absent) {
            all.push_back(title(*status.info));
        }
    }
    return all;
}

std::optional<std::size_t> placeOfChange(insight::WhatIf const& whatIf, Change::Kind kind,
                                         std::string const& object) {
    for (std::size_t i = 0; i < whatIf.changes.size(); ++i) {
        if (whatIf.changes[i].kind == kind && (object.empty() || whatIf.changes[i].object == object)) {
            return i;
        }
    }
    return std::nullopt;
}

void drawLeavingOut(Layout& layout, Session const& session, WhatIfView& view) {
    std::vector<std::size_t> later; // inputs of the hands after the moment
    for (std::size_t i = 0; i < session.inputs().size(); ++i) {
        RecordedInput const& input = session.inputs()[i];
        bool const begins = input.kind != PlayerInput::Kind::move && input.kind != PlayerInput::Kind::release;
        if (input.frame > view.moment() && begins) {
            later.push_back(i);
        }
    }
    auto const hands = placeOfChange(view.whatIf(), Change::Kind::input, "");
    if (!later.empty()) {
        bool without = hands.has_value();
        if (checkBox(text("Without what the hand does then"), &without)) {
            if (without) {
                view.leaveOut(later);
            } else if (hands) {
                view.takeBack(*hands);
            }
        }
        layout.item("without hands");
    }
    if (!ImGui::TreeNodeEx("without", ImGuiTreeNodeFlags_NoTreePushOnOpen, "%s",
                           text("Leave out an effect"))) {
        if (ImGui::IsItemVisible()) {
            layout.item("leave out");
        }
        return;
    }
    if (ImGui::IsItemVisible()) {
        layout.item("leave out");
    }
    std::vector<std::string> all = interactionsOf(session);
    for (std::string const& each : all) {
        auto const place = placeOfChange(view.whatIf(), Change::Kind::interaction, each);
        bool without = place.has_value();
        if (checkBox((translated(each) + "##" + each).c_str(), &without)) {
            if (without) {
                view.change({.kind = Change::Kind::interaction, .object = each});
            } else {
                view.takeBack(*place);
            }
        }
        if (ImGui::IsItemVisible()) {
            layout.item("without " + each);
        }
    }
}

void drawChanges(Layout& layout, Session const& session, WhatIfView& view) {
    std::optional<std::size_t> back;
    bool hands = false; // all their inputs together are one line
    for (std::size_t i = 0; i < view.whatIf().changes.size(); ++i) {
        Change const& change = view.whatIf().changes[i];
        if (change.kind == Change::Kind::input && std::exchange(hands, true)) {
            continue;
        }
        std::string const item = "take back " + std::to_string(i);
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton("×")) {
            back = i;
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", text("Take this back"));
        }
        if (ImGui::IsItemVisible()) {
            layout.item(item);
        }
        ImGui::SameLine(0, scaled(6));
        ImGui::TextWrapped("%s", wordsOf(change, session.world()).c_str());
        ImGui::PopID();
    }
    if (back) {
        view.takeBack(*back);
    }
}

std::string outcome(WhatIfView const& view) {
    insight::OtherRun const* const run = view.run();
    if (run == nullptr || view.whatIf().changes.empty()) {
        return "";
    }
    std::string words = run->firstDifference()
                            ? textWith("Another run from {} on.", secondsAt(*run->firstDifference()))
                            : std::string(text("No difference so far."));
    std::size_t met = 0;
    for (GoalStatus const& goal : run->goals()) {
        met += goal.frame ? 1U : 0U;
    }
    if (!run->goals().empty()) {
        words += " " + textWith("Goals reached in it: {} of {}", met, run->goals().size());
    }
    if (run->solvedFrame()) {
        words += " (" + secondsAt(*run->solvedFrame()) + ")";
    }
    return words;
}

/// While it is computed: how far, and a button that stops it; once stopped, one that lets it go on. Else as
/// much room, so that nothing moves when it begins or ends.
void drawComputing(Layout& layout, WhatIfView& view) {
    ImGui::PushFont(theme().fonts.small);
    if (!view.working()) {
        ImGui::Dummy({0, ImGui::GetFrameHeight()});
        ImGui::PopFont();
        return;
    }
    int const percent = static_cast<int>(100 * view.progress());
    bool const stopped = view.stopped();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(textWith(stopped ? "Stopped at {} %" : "Computing: {} %", percent).c_str());
    ImGui::SameLine(0, scaled(8));
    if (ImGui::SmallButton(stopped ? text("Compute on") : text("Stop computing"))) {
        if (stopped) {
            view.goOn();
        } else {
            view.stop();
        }
    }
    layout.item("what if computing");
    ImGui::PopFont();
}

} // namespace

void passKeysToCard(bool pass) {
    ImGuiIO& io = ImGui::GetIO();
    if (pass) {
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    }
}

void drawWhatIfCard(CommandButtons& buttons, Session const& session, WhatIfView& view, WhatIfTool& tool,
                    float above) {
    Layout& layout = buttons.layout();
    std::string const heading = textWith("What if, at {}", secondsAt(view.moment()));
    layout.beginCard("what if", heading.c_str(),
                     {.anchor = Anchor::BottomLeft, .offset = {cardGap, above}, .width = whatIfWidth});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
    float const screen = ImGui::GetIO().DisplaySize.y / theme().scale;
    float const room = std::clamp(screen - above - whatIfRest, leastList, whatIfList);
    if (tool.takeCardKeysNew()) {
        ImGui::SetNextWindowFocus();
    }
    // The ring moves on from the list to the buttons below it.
    ImGui::BeginChild("changes", {0, scaled(room)}, false, ImGuiWindowFlags_NavFlattened);
    if (view.whatIf().changes.empty()) {
        caption(text("Drag, turn or remove something, pull it with the second hand, or cut a wire."));
    }
    drawChanges(layout, session, view);
    if (!view.atMoment()) {
        caption(text("Only at its moment can something be changed."));
    } else {
        if (!tool.chosen().empty()) {
            drawWhatIfFields(layout, view, tool.chosen());
        }
        drawLeavingOut(layout, session, view);
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    drawComputing(layout, view);
    if (std::string const words = outcome(view); !words.empty()) {
        smallCaption(words.c_str());
    }
    if (!view.atMoment()) {
        if (bigButton(text("To its moment"), {.width = 128})) {
            view.toMoment();
        }
        layout.item("what if moment");
    } else if (view.whatIf().changes.empty() && !view.kept().empty()) {
        if (bigButton(text("The last one"), {.width = 128})) {
            view.again(view.kept().size() - 1);
        }
        layout.item("what if again");
    }
    layout.endCard();
}

} // namespace trembler::ui
