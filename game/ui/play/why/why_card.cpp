// How WhyPanel's card is drawn.
#include "game/ui/play/why/why_panel.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"
#include "render/panels/unbroken.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace trembler::ui {
namespace {

using namespace render;
using insight::Proof;

// Pixels at UI scale 1.
constexpr float numberSize = 24;
constexpr float rowGap = 6;

struct ProofLook {
    Phrase name;
    Phrase meaning;
};

/// By Proof; refuted causes are not shown.
constexpr std::array<ProofLook, 3> proofLooks{{
    {"seen", "Seen: it led there, and was not tried without."},
    {"sure", "Sure: the run was repeated without it, and it did not happen."},
    {"together", "Together: it did not happen without all of these."},
}};

ProofLook const& lookOf(Proof proof) {
    return proofLooks[std::min<std::size_t>(static_cast<std::size_t>(proof), 2)];
}

Colour colourOf(Proof proof) {
    return proof == Proof::confirmed  ? palette::goal
           : proof == Proof::together ? palette::accent
                                      : palette::inkSoft;
}

std::string momentOf(std::uint64_t frame) {
    return textWith("{:.2Lf} s", static_cast<double>(frame) / 60);
}

struct Row {
    std::string number; ///< "" for none
    std::string words;
    std::string note;
    Colour colour;
    bool filled = false;
};

std::string listed(std::vector<std::size_t> const& steps) {
    std::string numbers;
    for (std::size_t const step : steps) {
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(step + 1);
    }
    return numbers;
}

Row rowOf(insight::Answer const& answer, std::size_t step, std::string const& words) {
    insight::ChainStep const& one = answer.chain[step];
    Row row{std::to_string(step + 1), unbroken(words), unbroken(momentOf(one.step.frame)),
            colourOf(one.proof), one.proof != Proof::traced};
    row.note += " · " + std::string(lookOf(one.proof).name);
    if (one.times > 1) {
        row.note += " · " + textWith("{} times", one.times);
    }
    std::vector<std::size_t> const& because = one.step.because;
    if (!because.empty()) {
        row.note += " · " + textWith("because of {}", listed(because));
    }
    return row;
}

/// Returns whether it was clicked.
bool drawRow(Row const& row, std::string const& id, bool chosen) {
    Fonts const& fonts = theme().fonts;
    float const left = row.number.empty() ? scaled(rowGap) : scaled(numberSize + 10);
    float const width = ImGui::GetContentRegionAvail().x;
    float const wrap = width - left - scaled(rowGap);
    ImVec2 const words = fonts.body->CalcTextSizeA(fonts.body->FontSize, 1e9F, wrap, row.words.c_str());
    ImVec2 const note = row.note.empty()
                            ? ImVec2(0, 0)
                            : fonts.small->CalcTextSizeA(fonts.small->FontSize, 1e9F, wrap, row.note.c_str());
    float const high = std::max(words.y + note.y, scaled(numberSize)) + scaled(rowGap);
    ImVec2 const at = ImGui::GetCursorScreenPos();
    bool const clicked = ImGui::InvisibleButton(id.c_str(), {width, high});
    bool const hovered = ImGui::IsItemHovered();
    auto& list = *ImGui::GetWindowDrawList();
    if (chosen || hovered) {
        list.AddRectFilled(at, {at.x + width, at.y + high},
                           imColour(chosen ? faded(palette::accent, 0.16F) : palette::paperShade), scaled(7));
    }
    float const top = at.y + scaled(0.5F * rowGap);
    if (!row.number.empty()) {
        ImVec2 const middle{at.x + scaled(4 + 0.5F * numberSize), top + scaled(0.5F * numberSize)};
        if (row.filled) {
            list.AddCircleFilled(middle, scaled(0.5F * numberSize), imColour(row.colour));
        } else {
            list.AddCircle(middle, scaled(0.5F * numberSize - 1), imColour(row.colour), 0, scaled(1.8F));
        }
        ImVec2 const size = fonts.small->CalcTextSizeA(fonts.small->FontSize, 1e9F, 0, row.number.c_str());
        list.AddText(fonts.small, fonts.small->FontSize, {middle.x - 0.5F * size.x, middle.y - 0.5F * size.y},
                     imColour(row.filled ? palette::paperLight : palette::ink), row.number.c_str());
    }
    list.AddText(fonts.body, fonts.body->FontSize, {at.x + left, top}, imColour(palette::ink),
                 row.words.c_str(), nullptr, wrap);
    if (!row.note.empty()) {
        list.AddText(fonts.small, fonts.small->FontSize, {at.x + left, top + words.y},
                     imColour(palette::inkSoft), row.note.c_str(), nullptr, wrap);
    }
    return clicked;
}

} // namespace

void WhyPanel::drawHead(Layout& layout, float& used) {
    bool const missed = answer_ && !answer_->happened;
    float const side = scaled(40);
    float const room = ImGui::GetContentRegionAvail().x - side;
    ImVec2 const start = ImGui::GetCursorPos();
    ImGui::PushFont(theme().fonts.heading);
    ImGui::TextUnformatted(missed ? text("Why not?") : text("Why?"));
    ImGui::PopFont();
    ImVec2 const after = ImGui::GetCursorPos();
    ImGui::SetCursorPos({start.x + room, start.y});
    bool const busy = inquiry_.busy();
    if (iconButton("close why", busy ? Icon::Stop : Icon::Cross,
                   busy ? text("Stop, and show what is known by now") : words::closeTip)) {
        stopOrClose();
    }
    layout.item("close why");
    ImGui::SetCursorPos({start.x, std::max(after.y, ImGui::GetCursorPos().y)});
    if (std::string const subject = subjectText(); !subject.empty()) {
        caption(subject.c_str());
    }
    ImGui::Dummy({0, scaled(2)});
    used = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
}

void WhyPanel::drawWaiting(Layout& layout) {
    Inquiry::Progress const progress = inquiry_.progress();
    std::string const words = progress.of == 0 ? std::string(text("Repeating the run …"))
                                               : textWith("Repeating the run without each cause: {} of {}",
                                                          progress.done, progress.of);
    caption(words.c_str());
    float const share =
        progress.of == 0 ? 0.F : static_cast<float>(progress.done) / static_cast<float>(progress.of);
    ImVec2 const low = ImGui::GetCursorScreenPos();
    float const width = ImGui::GetContentRegionAvail().x;
    float const high = scaled(6);
    auto& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + high}, imColour(palette::paperShade), scaled(3));
    list.AddRectFilled(low, {low.x + share * width, low.y + high}, imColour(palette::accent), scaled(3));
    ImGui::Dummy({width, high});
    layout.item("why progress");
}

std::optional<std::uint64_t> WhyPanel::drawSteps(Layout& layout) {
    std::vector<std::string> const all = lines();
    std::optional<std::uint64_t> wanted;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, scaled(2)));
    for (std::size_t i = 0; i < all.size(); ++i) {
        Row row;
        bool const tells = answer_->happened;
        // The first line of a miss says that the goal was not met; the moment is that of the others.
        std::size_t const step = tells ? i : 0;
        if (tells) {
            row = rowOf(*answer_, i, all[i]);
        } else {
            row.words = unbroken(all[i]);
            row.colour = palette::inkSoft;
        }
        bool const chosen = step_ == step && (tells || i > 0);
        if (drawRow(row, "step " + std::to_string(i), chosen) && (tells || answer_->nearest)) {
            step_ = step;
            wanted = frameOf(step);
        }
        layout.item("why step " + std::to_string(i + 1));
        if (chosen && std::exchange(toStep_, false)) {
            ImGui::SetScrollHereY();
        }
    }
    ImGui::PopStyleVar();
    return wanted;
}

void WhyPanel::drawNotes() const {
    ImGui::Dummy({0, scaled(2)});
    if (!answer_->complete) {
        smallCaption(text("Stopped: not everything was tried."));
    }
    if (!answer_->happened) {
        return;
    }
    std::set<Proof> known;
    for (insight::ChainStep const& one : answer_->chain) {
        known.insert(one.proof);
    }
    for (Proof const proof : {Proof::confirmed, Proof::together, Proof::traced}) {
        if (known.contains(proof)) {
            smallCaption(lookOf(proof).meaning);
        }
    }
}

std::optional<std::uint64_t> WhyPanel::draw(Layout& layout, SidePlace const& place) {
    if (!open_) {
        return std::nullopt;
    }
    layout.beginCard(
        "why", "", {.anchor = Anchor::TopRight, .offset = {place.right, place.top}, .width = inspectorWidth});
    std::optional<std::uint64_t> wanted;
    float used = 0;
    drawHead(layout, used);
    if (inquiry_.busy()) {
        drawWaiting(layout);
    } else if (answer_) {
        // Text that does not fit scrolls; the height used is that of the last picture.
        float& content = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("height of the content"), 0);
        float const most = std::max(scaled(place.height) - used, scaled(80));
        bool const scrolls = content > most;
        if (scrolls) {
            ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
            ImGui::BeginChild("steps", {0, most});
        }
        float const begin = ImGui::GetCursorPosY();
        wanted = drawSteps(layout);
        drawNotes();
        content = ImGui::GetCursorPosY() - begin;
        if (scrolls) {
            ImGui::EndChild();
            ImGui::PopStyleColor();
        }
    } else if (nothing_) {
        caption(subject_.object.empty() ? text("Nothing is known of this.")
                                        : text("Nothing has happened to it so far."));
    } else {
        caption(textWith("This run cannot be repeated: {}", translated(fault_)).c_str());
    }
    layout.endCard();
    return wanted;
}

} // namespace trembler::ui
