#include "insight/probe/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler::insight {
namespace {

constexpr std::array<unsigned, 7> lineColours{0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7,
                                              0xE69F00, 0x56B4E9, 0x2E2925};

// Lengths of a picture, pixels.
constexpr double width = 960;
constexpr double panelHeight = 190;
constexpr double left = 74;
constexpr double right = 20;
constexpr double top = 46;
constexpr double gap = 46;
constexpr double bottom = 48;

std::string escaped(std::string const& text) {
    std::string all;
    for (char const c : text) {
        switch (c) {
        case '&':
            all += "&amp;";
            break;
        case '<':
            all += "&lt;";
            break;
        case '>':
            all += "&gt;";
            break;
        default:
            all += static_cast<unsigned char>(c) < 0x20 ? ' ' : c; // which XML does not allow
        }
    }
    return all;
}

std::string written(double x, double y, char const* anchor, std::string const& fill,
                    std::string const& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n", x, y,
                       anchor, fill, escaped(text));
}

std::string line(double x1, double y1, double x2, double y2, char const* stroke) {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1,
                       y1, x2, y2, stroke);
}

/// A path through the samples; interrupted where frames without a value lie between two.
std::string pathOf(Series const& series, std::uint64_t every, auto const& x, auto const& y) {
    std::string path;
    std::uint64_t before = 0;
    for (Sample const& sample : series.samples) {
        bool const begins = path.empty() || sample.frame > before + every;
        path += fmt::format("{}{:.2f} {:.2f}", begins ? "M" : "L", x(sample.frame), y(sample.value));
        before = sample.frame;
    }
    return path;
}

/// The greatest distance of frames that still counts as without a gap.
std::uint64_t spacingOf(Series const& series) {
    std::vector<std::uint64_t> steps;
    for (std::size_t i = 1; i < series.samples.size(); ++i) {
        steps.push_back(series.samples[i].frame - series.samples[i - 1].frame);
    }
    if (steps.empty()) {
        return 1;
    }
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                     steps.end());
    return 2 * steps[steps.size() / 2];
}

} // namespace

std::vector<double> Axis::ticks() const {
    std::vector<double> all;
    for (int i = 0; first + i * step <= high + 1e-9 * (high - low); ++i) {
        all.push_back(first + i * step);
    }
    return all;
}

Axis axisFor(double low, double high, int ticks) {
    low = std::isfinite(low) ? std::clamp(low, -1e300, 1e300) : 0;
    high = std::isfinite(high) ? std::clamp(high, -1e300, 1e300) : 0;
    if (high < low) {
        std::swap(low, high);
    }
    double const least = std::max({1e-9 * std::max(std::abs(low), std::abs(high)), 1e-12});
    if (high - low < least) {
        double const room = std::max(0.5 * std::abs(low), low == 0 && high == 0 ? 1.0 : least * 10);
        low -= room;
        high += room;
    }
    double const rough = (high - low) / std::max(ticks, 1);
    double const power = std::pow(10.0, std::floor(std::log10(rough)));
    double const share = rough / power;
    double const step = power * (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10);
    return {low, high, step, std::ceil(low / step - 1e-9) * step};
}

std::string tickText(double value, double step) {
    if (std::abs(value) < 1e-9 * step) {
        return "0";
    }
    if (step >= 1e6 || step < 1e-4) {
        return fmt::format("{:.3g}", value);
    }
    int const digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    return fmt::format("{:.{}f}", value, digits);
}

std::vector<Panel> panelsOf(std::span<Series const> series, int ticks) {
    std::vector<Panel> panels;
    for (Series const& each : series) {
        auto at = std::find_if(panels.begin(), panels.end(),
                               [&](Panel const& panel) { return panel.unit == each.unit; });
        if (at == panels.end()) {
            at = panels.insert(panels.end(), {each.unit, {}, {}});
        }
        at->series.push_back(&each);
    }
    for (Panel& panel : panels) {
        double low = 0;
        double high = 0;
        bool any = false;
        for (Series const* const each : panel.series) {
            for (Sample const& sample : each->samples) {
                if (std::isfinite(sample.value)) {
                    low = any ? std::min(low, sample.value) : sample.value;
                    high = any ? std::max(high, sample.value) : sample.value;
                    any = true;
                }
            }
        }
        panel.axis = axisFor(low, high, ticks);
    }
    return panels;
}

unsigned lineColour(std::size_t n) {
    return lineColours[n % lineColours.size()];
}

std::string plotAsSvg(std::string const& title, std::span<Series const> series, std::uint64_t last) {
    constexpr char const* ink = "#2e2925";
    constexpr char const* grid = "#e7dbc5";
    std::vector<Panel> const panels = panelsOf(series, 4);
    auto const count = static_cast<double>(std::max<std::size_t>(panels.size(), 1));
    double const height = top + count * panelHeight + (count - 1) * gap + bottom;
    Axis const time = [last] {
        Axis axis = axisFor(0, static_cast<double>(std::max<std::uint64_t>(last, 1)) / 60, 8);
        return axis;
    }();
    auto const x = [&](auto frame) {
        return left + time.share(static_cast<double>(frame) / 60) * (width - left - right);
    };
    std::string svg =
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}\" height=\"{1}\" "
                    "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"13\">\n"
                    "<rect width=\"{0}\" height=\"{1}\" fill=\"#fbf7ee\"/>\n",
                    width, height);
    svg += written(left, 20, "start", ink, title);
    double begin = top;
    for (Panel const& panel : panels) {
        double const end = begin + panelHeight;
        auto const y = [&](double value) { return end - panel.axis.share(value) * panelHeight; };
        for (double const tick : panel.axis.ticks()) {
            svg += line(left, y(tick), width - right, y(tick), grid);
            svg += written(left - 8, y(tick) + 4, "end", ink, tickText(tick, panel.axis.step));
        }
        for (double const tick : time.ticks()) {
            svg += line(x(60 * tick), begin, x(60 * tick), end, grid);
        }
        svg +=
            fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\"/>\n",
                        left, begin, width - left - right, panelHeight, ink);
        double at = left + 6;
        for (std::size_t i = 0; i < panel.series.size(); ++i) {
            Series const& each = *panel.series[i];
            std::string const colour = fmt::format("#{:06x}", lineColour(i));
            svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n",
                               pathOf(each, spacingOf(each), x, y), colour);
            svg += written(at, begin - 7, "start", colour, each.name);
            at += 12 + 7.4 * static_cast<double>(each.name.size());
        }
        if (!panel.unit.empty()) {
            svg += written(width - right, begin - 7, "end", ink, panel.unit);
        }
        begin = end + gap;
    }
    double const axisAt = height - bottom;
    for (double const tick : time.ticks()) {
        svg += written(x(60 * tick), axisAt + 18, "middle", ink, tickText(tick, time.step));
    }
    svg += written(width - right, axisAt + 36, "end", ink, "s");
    return svg + "</svg>\n";
}

} // namespace trembler::insight
