#include "game/ui/play/timeline/probe_panel.hpp"

#include "game/ui/cards/play_cards.hpp"
#include "game/ui/play/timeline/timeline_bar.hpp"
#include "game/ui/shared/texts.hpp"
#include "insight/probe/plot.hpp"
#include "insight/probe/watch_table.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/check_box.hpp"
#include "render/panels/theme.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

namespace trembler::ui {
namespace {

using namespace render;
using insight::Panel;
using insight::Series;

// Pixels at UI scale 1.
constexpr float plotHeight = 58; ///< of a panel
constexpr float mostHeight = 190;
constexpr float plotGap = 6;
constexpr float choiceWidth = 300;
constexpr float choiceHeight = 250;

constexpr int framesPerPicture = 300; // that are read

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

/// "coil.electrical_quantities.current" as "coil: Current"; others with the field as it is called.
std::string labelOf(std::string const& what) {
    for (Usual const& each : usual) {
        std::string const end = std::string(".") + each.field;
        if (what.size() > end.size() && what.ends_with(end)) {
            return shownName(what.substr(0, what.size() - end.size())) + ": " + each.name;
        }
    }
    return what;
}

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
void drawLine(Plot const& plot, Panel const& panel, Series const& series, ImU32 colour) {
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
    plot.list.AddPolyline(path.data(), static_cast<int>(path.size()), colour, 0, scaled(1.6F));
    plot.list.PopClipRect();
}

} // namespace

ProbePanel::ProbePanel(Registry const& registry, Session const& session)
    : registry_(registry), session_(session),
      stage_([&registry, &session] { return insight::buildAgain(registry, session); }) {}

void ProbePanel::findFields() {
    if (fields_.empty()) {
        fields_ = watch::watchedFields(registry_);
    }
}

void ProbePanel::toggle(std::string const& what) {
    findFields();
    if (probes_.has(what)) {
        probes_.remove(what);
        return;
    }
    probes_.add(session_.world(), fields_, what);
    probes_.clearSamples(); // all are read again, together
}

void ProbePanel::removeAll() {
    probes_ = {};
}

void ProbePanel::forget() {
    probes_.clearSamples();
    stage_.forget();
}

void ProbePanel::forgetAfter(std::uint64_t frame) {
    probes_.forgetAfter(frame);
}

bool ProbePanel::read(insight::Recording const& recording) {
    if (probes_.watches().empty() || !recording.begun()) {
        return false;
    }
    bool any = false;
    for (int i = 0; i < framesPerPicture; ++i) {
        auto const next = probes_.last() ? recording.after(*probes_.last()) : std::optional<std::uint64_t>(0);
        if (!next) {
            break;
        }
        try {
            stage_.show(recording, *next);
        } catch (InputError const&) { // the level cannot be built any more; Timeline says so
            break;
        }
        probes_.look(stage_.world(), *next);
        any = true;
    }
    return any;
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

float ProbePanel::height() const {
    if (probes_.series().empty()) {
        return 0;
    }
    auto const panels = static_cast<float>(insight::panelsOf(probes_.series(), 2).size());
    return std::min(panels * (plotHeight + plotGap), mostHeight) + plotGap;
}

std::optional<std::uint64_t> ProbePanel::draw(Layout& layout, std::uint64_t frame, std::uint64_t last) {
    std::vector<Panel> const panels = insight::panelsOf(probes_.series(), 2);
    float const width = ImGui::GetIO().DisplaySize.x / theme().scale - 2 * cardGap;
    layout.beginCard("probes", "",
                     {.anchor = Anchor::BottomLeft,
                      .offset = {cardGap, bottomRow + timelineRow},
                      .width = width,
                      .bare = true});
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
        for (std::size_t i = 0; i < panel.series.size(); ++i) {
            Series const& series = *panel.series[i];
            drawLine(plot, panel, series, lineColour(i));
            if (auto const value = series.at(frame)) {
                list.AddCircleFilled({plot.x(frame), plot.y(panel, *value)}, scaled(3), lineColour(i));
            }
        }
        list.PushClipRect({right, top}, {origin.x + scaled(width - 4), top + each}, true);
        for (std::size_t i = 0; i < panel.series.size(); ++i) {
            float const y = plot.low.y + static_cast<float>(i) * line;
            if (y + line > top + each) {
                break; // there is no room for its words
            }
            Series const& series = *panel.series[i];
            auto const value = series.at(frame);
            std::string const words =
                (value ? shownNumber(*value) : std::string("–")) + "  " + labelOf(series.name);
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

std::string ProbePanel::drawChoice(Layout& layout, World const& world, std::string const& object,
                                   float above) {
    findFields();
    std::string wanted;
    layout.beginCard("probe choice", text("Plot"),
                     {.anchor = Anchor::BottomLeft, .offset = {cardGap, above}, .width = choiceWidth});
    if (object.empty()) {
        caption(text("Click on an object: then its numbers are listed here."));
    } else {
        ImGui::PushFont(theme().fonts.strong);
        ImGui::TextUnformatted(shownName(object).c_str());
        ImGui::PopFont();
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("quantities", {0, scaled(choiceHeight - 110)});
        for (Quantity const& quantity : quantitiesOf(world, object)) {
            bool on = probes_.has(quantity.what);
            if (render::checkBox((quantity.name + "##" + quantity.what).c_str(), &on)) {
                toggle(quantity.what);
            }
            layout.item("plot " + quantity.what);
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

std::string ProbePanel::csv() const {
    std::string all = watch::csvHeader(probes_.watches()) + "\n";
    std::set<std::uint64_t> frames;
    for (Series const& series : probes_.series()) {
        for (insight::Sample const& sample : series.samples) {
            frames.insert(sample.frame);
        }
    }
    std::vector<std::size_t> next(probes_.series().size(), 0);
    for (std::uint64_t const frame : frames) {
        std::vector<watch::Cell> row(next.size());
        for (std::size_t i = 0; i < next.size(); ++i) {
            auto const& samples = probes_.series()[i].samples;
            if (next[i] < samples.size() && samples[next[i]].frame == frame) {
                row[i] = samples[next[i]++].value;
            }
        }
        all += watch::csvRow(frame, row) + "\n";
    }
    return all;
}

std::string ProbePanel::svg(std::uint64_t last) const {
    return insight::plotAsSvg(session_.level().title, probes_.series(), last);
}

} // namespace trembler::ui
