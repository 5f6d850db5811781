// The card of the plots above the timeline.
#include "game/ui/play/timeline/probe_panel.hpp"
#include "game/ui/play/timeline/probe_words.hpp"
#include "game/ui/play/timeline/timeline_bar.hpp"
#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/texts.hpp"
#include "insight/probe/plot.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/theme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

using namespace render;
using insight::Panel;
using insight::Series;

// Pixels at UI scale 1.
constexpr float plotHeight = 58; ///< of a panel
constexpr float mostHeight = 190;
constexpr float plotGap = 6;
constexpr float runWidth = 1.6F;   ///< of the run's lines
constexpr float otherWidth = 3.2F; ///< of the lines of a run beside it, which are pale
constexpr float otherAlpha = 0.4F;

ImU32 lineColour(std::size_t n, float alpha = 1) {
    unsigned const rgb = insight::lineColour(n);
    return IM_COL32((rgb >> 16U) & 255U, (rgb >> 8U) & 255U, rgb & 255U, static_cast<int>(255 * alpha));
}

std::string shownNumber(double value) {
    double const size = std::abs(value);
    std::string const number = size != 0 && (size < 1e-3 || size >= 1e6) ? fmt::format("{:.3g}", value)
                               : size >= 100                             ? fmt::format("{:.1f}", value)
                                                                         : fmt::format("{:.3f}", value);
    return localNumber(number);
}

/// One plot: its grid, its lines, and at the right the values in the shown frame.
struct Plot {
    ImDrawList& list;
    ImVec2 low; ///< of the part in which the lines are
    ImVec2 high;
    std::uint64_t frame = 0;
    std::uint64_t last = 1;

    [[nodiscard]] float x(std::uint64_t at) const {
        return low.x + (high.x - low.x) * std::min(1.F, static_cast<float>(at) / static_cast<float>(last));
    }
    [[nodiscard]] float y(Panel const& panel, double value) const {
        double const share = std::clamp(panel.axis.share(value), -0.05, 1.05);
        return high.y - static_cast<float>(share) * (high.y - low.y);
    }
};

void drawGrid(Plot const& plot, Panel const& panel) {
    plot.list.AddRectFilled(plot.low, plot.high, imColour(palette::paperLight));
    std::vector<double> const ticks = panel.axis.ticks();
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        float const y = plot.y(panel, ticks[i]);
        plot.list.AddLine({plot.low.x, y}, {plot.high.x, y}, imColour(palette::paperShade), scaled(1));
        std::string const text = localNumber(insight::tickText(ticks[i], panel.axis.step));
        ImVec2 const size = ImGui::CalcTextSize(text.c_str());
        float const top = y - 0.5F * size.y;
        if (top > plot.low.y - 0.6F * size.y && top + size.y < plot.high.y + 0.6F * size.y) {
            plot.list.AddText({plot.low.x - size.x - scaled(5), top}, imColour(palette::inkSoft),
                              text.c_str());
        }
    }
    plot.list.AddRect(plot.low, plot.high, imColour(palette::paperShade), 0, 0, scaled(1.2F));
}

/// Of samples that fall into one column of pixels only the first, the least, the greatest and the last are
/// drawn.
void drawLine(Plot const& plot, Panel const& panel, Series const& series, ImU32 colour,
              float width = runWidth) {
    std::vector<ImVec2> path;
    std::size_t i = 0;
    while (i < series.samples.size()) {
        float const column = std::floor(plot.x(series.samples[i].frame));
        double low = series.samples[i].value;
        double high = low;
        double const first = low;
        double lastValue = low;
        float const at = plot.x(series.samples[i].frame);
        for (; i < series.samples.size() && std::floor(plot.x(series.samples[i].frame)) == column; ++i) {
            lastValue = series.samples[i].value;
            low = std::min(low, lastValue);
            high = std::max(high, lastValue);
        }
        for (double const value : {first, low, high, lastValue}) {
            ImVec2 const point{at, plot.y(panel, value)};
            if (path.empty() || path.back().x != point.x || path.back().y != point.y) {
                path.push_back(point);
            }
        }
    }
    float const edge = scaled(2); // the line of the greatest value is as wide as others
    plot.list.PushClipRect({plot.low.x, plot.low.y - edge}, {plot.high.x, plot.high.y + edge}, true);
    // In pieces, because one call may add at most 65,535 vertices: see render/panels/long_text.hpp.
    constexpr std::size_t piece = 4000;
    for (std::size_t from = 0; from + 1 < path.size(); from += piece) {
        std::size_t const count = std::min(piece + 1, path.size() - from);
        plot.list.AddPolyline(path.data() + from, static_cast<int>(count), colour, 0, scaled(width));
    }
    plot.list.PopClipRect();
}

/// How many series of the panel are of the run itself, which are the first `count` of all.
std::size_t seriesOfRun(Panel const& panel, std::size_t count, std::vector<Series> const& all) {
    return static_cast<std::size_t>(
        std::count_if(panel.series.begin(), panel.series.end(), [&](Series const* each) {
            return static_cast<std::size_t>(each - all.data()) < count;
        }));
}

} // namespace

float ProbePanel::height() const {
    if (probes_.series().empty()) {
        return 0;
    }
    auto const panels = static_cast<float>(insight::panelsOf(probes_.series(), 2).size());
    return std::min(panels * (plotHeight + plotGap), mostHeight) + plotGap;
}

std::optional<std::uint64_t> ProbePanel::draw(Layout& layout, float above, std::uint64_t frame,
                                              std::uint64_t last) {
    // In a panel the series of the run come first, in their order; then those of the run beside it.
    std::vector<Series> both = probes_.series();
    both.insert(both.end(), other_.series().begin(), other_.series().end());
    std::vector<Panel> const panels = insight::panelsOf(both, 2);
    float const width = ImGui::GetIO().DisplaySize.x / theme().scale - 2 * cardGap;
    layout.beginCard(
        "probes", "",
        {.anchor = Anchor::BottomLeft, .offset = {cardGap, above}, .width = width, .bare = true});
    ImVec2 const origin = ImGui::GetCursorScreenPos();
    float const all = scaled(height() - plotGap);
    ImGui::InvisibleButton("plots", {ImGui::GetContentRegionAvail().x, all});
    bool const held = ImGui::IsItemActive();
    layout.item("plots");
    auto& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(origin, {origin.x + scaled(width), origin.y + all},
                       imColour(faded(palette::paperLight, 0.94F)), scaled(9));
    ImGui::PushFont(theme().fonts.small);
    float const line = ImGui::GetTextLineHeight();
    float const left = origin.x + scaled(trackFromLeft);
    float const right = origin.x + scaled(width - trackFromRight);
    float const each = all / static_cast<float>(panels.size());
    for (std::size_t n = 0; n < panels.size(); ++n) {
        Panel const& panel = panels[n];
        float const top = origin.y + static_cast<float>(n) * each;
        Plot const plot{list,
                        {left, top + scaled(plotGap)},
                        {right, top + each - scaled(plotGap)},
                        frame,
                        std::max<std::uint64_t>(last, 1)};
        drawGrid(plot, panel);
        list.AddText({origin.x + scaled(8), plot.low.y}, imColour(palette::ink), panel.unit.c_str());
        std::size_t const ofRun = seriesOfRun(panel, probes_.series().size(), both);
        for (std::size_t i = ofRun; i < panel.series.size(); ++i) {
            drawLine(plot, panel, *panel.series[i], lineColour(i - ofRun, otherAlpha), otherWidth);
        }
        for (std::size_t i = 0; i < ofRun; ++i) {
            Series const& series = *panel.series[i];
            drawLine(plot, panel, series, lineColour(i));
            if (auto const value = series.at(frame)) {
                list.AddCircleFilled({plot.x(frame), plot.y(panel, *value)}, scaled(3), lineColour(i));
            }
        }
        list.PushClipRect({right, top}, {origin.x + scaled(width - 4), top + each}, true);
        for (std::size_t i = 0; i < ofRun; ++i) {
            float const y = plot.low.y + static_cast<float>(i) * line;
            if (y + line > top + each) {
                break; // there is no room for its words
            }
            Series const& series = *panel.series[i];
            auto const value = series.at(frame);
            std::string const words =
                (value ? shownNumber(*value) : std::string("–")) + "  " + plotLabel(series.name);
            list.AddText({right + scaled(8), y}, lineColour(i), words.c_str());
        }
        list.PopClipRect();
        list.AddLine({plot.x(frame), plot.low.y}, {plot.x(frame), plot.high.y},
                     imColour(faded(palette::accentDeep, 0.7F)), scaled(1.5F));
    }
    ImGui::PopFont();
    layout.endCard();
    if (!held || right <= left) {
        return std::nullopt;
    }
    float const share = std::clamp((ImGui::GetIO().MousePos.x - left) / (right - left), 0.F, 1.F);
    auto const wanted = static_cast<std::uint64_t>(std::lround(share * static_cast<float>(last)));
    return wanted != frame ? std::optional(wanted) : std::nullopt;
}

} // namespace trembler::ui
