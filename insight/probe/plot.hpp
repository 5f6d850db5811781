// Several series over time as a plot: the axes that windows and files share, and the file.
#pragma once

#include "insight/probe/series.hpp"

#include <span>
#include <string>
#include <vector>

namespace trembler::insight {

/// The range of an axis, and the round numbers at which it has ticks.
struct Axis {
    double low = 0;
    double high = 1;
    double step = 1;  ///< between ticks
    double first = 0; ///< tick
    [[nodiscard]] std::vector<double> ticks() const;
    /// 0 at `low`, 1 at `high`.
    [[nodiscard]] double share(double value) const { return (value - low) / (high - low); }
};

/// An axis with about that many ticks that shows all values between `low` and `high`. One value alone, or
/// none, gets room around it. Values that are not finite count as 0.
[[nodiscard]] Axis axisFor(double low, double high, int ticks);
/// As short as the step allows: "0.25", "1e+07".
[[nodiscard]] std::string tickText(double value, double step);

/// The series that have a unit in common: they share an axis.
struct Panel {
    std::string unit;
    std::vector<Series const*> series;
    Axis axis;
};

/// In the order in which the units come. The series must outlive them.
[[nodiscard]] std::vector<Panel> panelsOf(std::span<Series const> series, int ticks);

/// The red, green and blue of the line number n, distinguishable for the colour-blind (Okabe and Ito).
[[nodiscard]] unsigned lineColour(std::size_t n);

/// A picture of all series over the frames up to `last`, in SVG 1.1: a panel for each unit above a common
/// axis of time in seconds, with the names of the lines. `title` stands above it.
[[nodiscard]] std::string plotAsSvg(std::string const& title, std::span<Series const> series,
                                    std::uint64_t last);

} // namespace trembler::insight
