#include "game/ui/play/timeline/timeline_bar.hpp"

#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace trembler::ui {
namespace {

using namespace render;
using insight::Mark;
using insight::MarkKind;

// Pixels at UI scale 1.
constexpr float trackHeight = 42;
constexpr float timeWidth = 112;
constexpr float buttonGap = 4;
constexpr float knob = 6.5F;
constexpr float perMark = 15; ///< marks that are closer are shown as one
constexpr std::size_t linesOfTip = 6;

struct MarkLook {
    Phrase name;
    Icon icon;
    Colour const* colour; ///< of the palette in use
    int rank;             ///< of several at one place the highest is drawn
};

/// By MarkKind.
constexpr std::array<MarkLook, insight::markKinds> looks{{
    {"Contact", Icon::Contact, &palette::ink, 4},
    {"Contact opened", Icon::Contact, &palette::deadWire, 3},
    {"On", Icon::Bolt, &palette::northPole, 10},
    {"Off", Icon::Bolt, &palette::deadWire, 5},
    {"Sound", Icon::Record, &palette::sound, 2},
    {"Broken", Icon::Cross, &palette::warning, 12},
    {"Cut through", Icon::Scissors, &palette::warning, 11},
    {"Goal reached", Icon::Tick, &palette::goal, 13},
    {"First touch", Icon::Plus, &palette::contact, 1},
    {"Into the liquid", Icon::Record, &palette::water, 7},
    {"Out of the liquid", Icon::Record, &palette::deadWire, 6},
    {"Magnetic", Icon::Magnet, &palette::northPole, 9},
    {"No longer magnetic", Icon::Magnet, &palette::deadWire, 8},
}};

MarkLook const& lookOf(Mark const& mark) {
    return looks[static_cast<std::size_t>(mark.kind)];
}

std::string secondsOf(std::uint64_t frame) {
    return textWith("{:.2Lf} s", static_cast<double>(frame) / 60);
}

/// Where frames are on the screen.
struct Track {
    ImVec2 low;
    ImVec2 high;
    std::uint64_t last = 0;

    [[nodiscard]] float left() const { return low.x + scaled(knob + 5); }
    [[nodiscard]] float right() const { return high.x - scaled(knob + 5); }
    [[nodiscard]] float x(std::uint64_t frame) const {
        float const share = last == 0 ? 0.F : static_cast<float>(frame) / static_cast<float>(last);
        return left() + std::min(share, 1.F) * (right() - left());
    }
    [[nodiscard]] std::uint64_t frameAt(float x) const {
        float const share = std::clamp((x - left()) / std::max(right() - left(), 1.F), 0.F, 1.F);
        return static_cast<std::uint64_t>(std::lround(share * static_cast<float>(last)));
    }
    [[nodiscard]] float bar() const { return low.y + 0.72F * (high.y - low.y); }
    [[nodiscard]] float marks() const { return low.y + 0.30F * (high.y - low.y); }
};

/// Marks that are shown as one, ascending by frame.
using Heap = std::vector<Mark const*>;

std::map<int, Heap> heapsOf(Timeline const& timeline, Track const& track) {
    std::map<int, Heap> heaps;
    for (Mark const& mark : timeline.marks().all()) {
        heaps[static_cast<int>((track.x(mark.frame) - track.left()) / scaled(perMark))].push_back(&mark);
    }
    return heaps;
}

Mark const& foremost(Heap const& heap) {
    return **std::max_element(heap.begin(), heap.end(),
                              [](Mark const* a, Mark const* b) { return lookOf(*a).rank < lookOf(*b).rank; });
}

void tipOf(Heap const& heap) {
    std::string words;
    for (std::size_t i = 0; i < heap.size() && i < linesOfTip; ++i) {
        words += (i > 0 ? "\n" : "") + secondsOf(heap[i]->frame) + "   " + wordsOf(*heap[i]);
    }
    if (heap.size() > linesOfTip) {
        words += "\n" + textWith("and {} more", heap.size() - linesOfTip);
    }
    ImGui::SetTooltip("%s", words.c_str());
}

/// Returns the mark under the mouse.
Mark const* drawMarks(ImDrawList& list, Timeline const& timeline, Track const& track, bool hovered) {
    ImVec2 const mouse = ImGui::GetIO().MousePos;
    bool const inLane = hovered && std::abs(mouse.y - track.marks()) < scaled(0.5F * perMark);
    Mark const* under = nullptr;
    for (auto const& [place, heap] : heapsOf(timeline, track)) {
        Mark const& mark = foremost(heap);
        float const x = track.x(mark.frame);
        MarkLook const& look = lookOf(mark);
        list.AddLine({x, track.marks() + scaled(6)}, {x, track.bar() - scaled(3)},
                     imColour(faded(*look.colour, 0.45F)), scaled(1.2F));
        drawIcon(list, look.icon, {x, track.marks()}, scaled(11), imColour(*look.colour));
        if (inLane && std::abs(mouse.x - x) < scaled(0.5F * perMark)) {
            under = &mark;
            tipOf(heap);
        }
    }
    return under;
}

void drawTrack(ImDrawList& list, Timeline const& timeline, Track const& track) {
    ImVec2 const end{track.high.x + scaled(timeWidth - buttonGap), track.high.y}; // the time beside it, too
    list.AddRectFilled(track.low, end, imColour(palette::paperLight), scaled(9));
    list.AddRect(track.low, end, imColour(palette::paperShade), scaled(9), 0, scaled(1.5F));
    float const half = scaled(3);
    float const y = track.bar();
    list.AddRectFilled({track.left(), y - half}, {track.right(), y + half}, imColour(palette::paperShade),
                       half);
    if (auto const loop = timeline.loop()) {
        list.AddRectFilled({track.x(loop->first), y - 2.2F * half}, {track.x(loop->second), y + 2.2F * half},
                           imColour(faded(palette::accent, 0.28F)), half);
    }
    float const x = track.x(timeline.frame());
    list.AddRectFilled({track.left(), y - half}, {std::max(x, track.left() + half), y + half},
                       imColour(palette::accent), half);
}

void drawKnob(ImDrawList& list, Timeline const& timeline, Track const& track) {
    ImVec2 const at{track.x(timeline.frame()), track.bar()};
    list.AddLine({at.x, track.low.y + scaled(4)}, at, imColour(faded(palette::accentDeep, 0.6F)),
                 scaled(1.5F));
    list.AddCircleFilled(at, scaled(knob),
                         imColour(timeline.looksBack() ? palette::accent : palette::paperLight));
    list.AddCircle(at, scaled(knob), imColour(palette::accentDeep), 0, scaled(2));
}

} // namespace

std::string wordsOf(Mark const& mark) {
    std::string names;
    for (std::string const& object : mark.objects) {
        names += (names.empty() ? "" : ", ") + shownName(object);
    }
    std::string const name = lookOf(mark).name;
    return names.empty() ? name : name + ": " + names;
}

TimelineRequest drawTimelineBar(CommandButtons& buttons, Timeline const& timeline) {
    Layout& layout = buttons.layout();
    float const width = ImGui::GetIO().DisplaySize.x / theme().scale - 2 * cardGap;
    layout.beginCard(
        "timeline", "",
        {.anchor = Anchor::BottomLeft, .offset = {cardGap, bottomRow}, .width = width, .bare = true});
    for (char const* id : {"frame-back", "watch-past", "frame-on"}) {
        buttons.icon(id);
        ImGui::SameLine(0, scaled(buttonGap));
    }
    ImVec2 const low = ImGui::GetCursorScreenPos();
    ImVec2 const size{std::max(ImGui::GetContentRegionAvail().x - scaled(trackFromRight), scaled(80)),
                      scaled(trackHeight)};
    Track const track{low, {low.x + size.x, low.y + size.y}, timeline.last()};
    ImGui::InvisibleButton("track", size);
    bool const hovered = ImGui::IsItemHovered();
    bool const held = ImGui::IsItemActive();
    bool const pressed = ImGui::IsItemActivated();
    layout.item("timeline track");
    auto& list = *ImGui::GetWindowDrawList();
    drawTrack(list, timeline, track);
    Mark const* const mark = drawMarks(list, timeline, track, hovered && !(held && !pressed));
    drawKnob(list, timeline, track);
    TimelineRequest request;
    std::optional<std::uint64_t> wanted;
    float const strayed = std::sqrt(ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left]);
    if (ImGui::IsItemDeactivated() && mark != nullptr && strayed < ImGui::GetIO().MouseDragThreshold) {
        request.why = *mark;
    }
    if (held) {
        wanted = pressed && mark != nullptr ? mark->frame : track.frameAt(ImGui::GetIO().MousePos.x);
        if (mark != nullptr && !ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
            wanted = mark->frame; // a press that does not move stays at the mark
        }
    }
    ImGui::SameLine(0, scaled(buttonGap));
    std::string const now = secondsOf(timeline.frame());
    std::string const all = "/ " + secondsOf(timeline.last());
    ImVec2 const corner = ImGui::GetCursorScreenPos();
    float const right = corner.x + scaled(timeWidth - 5 * buttonGap);
    auto const write = [&](std::string const& words, float top, Colour colour) {
        float const wide = ImGui::CalcTextSize(words.c_str()).x;
        list.AddText({right - wide, top}, imColour(colour), words.c_str());
    };
    ImGui::PushFont(theme().fonts.strong);
    write(now, corner.y + scaled(2), timeline.looksBack() ? palette::accentDeep : palette::ink);
    ImGui::PopFont();
    write(all, corner.y + scaled(22), palette::inkSoft);
    ImGui::Dummy({scaled(timeWidth - buttonGap), scaled(trackHeight)});
    for (char const* id : {"probe", "what-if", "loop-past", "continue-here"}) {
        ImGui::SameLine(0, scaled(buttonGap));
        buttons.icon(id);
    }
    layout.endCard();
    if (wanted && *wanted != timeline.frame()) {
        request.frame = wanted;
    }
    return request;
}

} // namespace trembler::ui
