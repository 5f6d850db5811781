#include "measure/accuracy/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::accuracy {
namespace {

constexpr double left = 90;
constexpr double top = 60;
constexpr double width = 430;
constexpr double height = 300;
constexpr double legend = left + width + 34;
constexpr char const* frontColour = "#2b6ca3";
constexpr char const* restColour = "#b3541e";

std::string escaped(std::string const& text) {
    std::string result;
    for (char const c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

// The range of a logarithmic axis: whole decades that contain all values, at least one.
struct Axis {
    int low = 0;
    int high = 1;
    explicit Axis(std::vector<double> const& values) {
        if (!values.empty()) {
            auto const [least, most] = std::minmax_element(values.begin(), values.end());
            low = static_cast<int>(std::floor(std::log10(*least)));
            high = std::max(low + 1, static_cast<int>(std::ceil(std::log10(*most))));
        }
    }
    [[nodiscard]] double share(double value) const { return (std::log10(value) - low) / (high - low); }
    // Decades between labels, so that there are at most about a dozen.
    [[nodiscard]] int step() const { return (high - low) / 12 + 1; }
};

class Picture {
public:
    explicit Picture(Ladder const& ladder) : x_(times(ladder)), y_(errors(ladder)), exact_(anyExact(ladder)) {
        text_ = fmt::format(
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 760 430' font-family='sans-serif' "
            "font-size='12' fill='#333'>\n<rect width='760' height='430' fill='#faf6ec'/>\n"
            "<text x='{}' y='24' font-size='15'>{}: {}</text>\n"
            "<text x='{}' y='44'>{} ({})</text>\n",
            left, escaped(ladder.effect), escaped(ladder.scene), left, escaped(ladder.error),
            escaped(ladder.unit));
        grid();
        front(ladder);
        dots(ladder);
        text_ += "</svg>\n";
    }
    [[nodiscard]] std::string const& text() const { return text_; }

private:
    static std::vector<double> times(Ladder const& ladder) {
        std::vector<double> values;
        for (Rung const& rung : ladder.rungs) {
            if (rung.microseconds > 0) {
                values.push_back(rung.microseconds);
            }
        }
        return values;
    }
    // Rounding errors are drawn as exact: they would stretch the axis over many empty decades.
    static constexpr double nothing = 1e-12;
    static std::vector<double> errors(Ladder const& ladder) {
        std::vector<double> values;
        for (Rung const& rung : ladder.rungs) {
            if (rung.error > nothing && std::isfinite(rung.error)) {
                values.push_back(rung.error);
            }
        }
        return values;
    }
    static bool anyExact(Ladder const& ladder) {
        return std::any_of(ladder.rungs.begin(), ladder.rungs.end(),
                           [](Rung const& rung) { return rung.error <= nothing; });
    }
    [[nodiscard]] double x(Rung const& rung) const {
        return left + (rung.microseconds > 0 ? width * x_.share(rung.microseconds) : 0);
    }
    [[nodiscard]] double y(Rung const& rung) const {
        double const room = exact_ ? height - 30 : height;
        if (!std::isfinite(rung.error)) {
            return top;
        }
        return rung.error <= nothing ? top + height : top + room * (1 - y_.share(rung.error));
    }
    void grid() {
        for (int decade = x_.low; decade <= x_.high; decade += x_.step()) {
            double const at = left + width * (decade - x_.low) / (x_.high - x_.low);
            text_ += fmt::format("<line x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}' stroke='#d8d0bf'/>"
                                 "<text x='{0:.1f}' y='{3}' text-anchor='middle'>{4:g}</text>\n",
                                 at, top, top + height, top + height + 18, std::pow(10.0, decade));
        }
        double const room = exact_ ? height - 30 : height;
        for (int decade = y_.low; decade <= y_.high; decade += y_.step()) {
            double const at = top + room * (1 - static_cast<double>(decade - y_.low) / (y_.high - y_.low));
            text_ += fmt::format("<line x1='{0}' x2='{1}' y1='{2:.1f}' y2='{2:.1f}' stroke='#d8d0bf'/>"
                                 "<text x='{3}' y='{4:.1f}' text-anchor='end'>{5:g}</text>\n",
                                 left, left + width, at, left - 8, at + 4, std::pow(10.0, decade));
        }
        if (exact_) {
            text_ += fmt::format(
                "<line x1='{0}' x2='{1}' y1='{2}' y2='{2}' stroke='#d8d0bf' stroke-dasharray='4 4'/>"
                "<text x='{3}' y='{4}' text-anchor='end'>exact</text>\n",
                left, left + width, top + height, left - 8, top + height + 4);
        }
        text_ += fmt::format("<text x='{}' y='{}' text-anchor='middle'>µs per frame</text>\n",
                             left + width / 2, top + height + 42);
    }
    void front(Ladder const& ladder) {
        std::vector<Rung const*> on;
        for (Rung const& rung : ladder.rungs) {
            if (rung.onFront) {
                on.push_back(&rung);
            }
        }
        std::sort(on.begin(), on.end(),
                  [](Rung const* a, Rung const* b) { return a->microseconds < b->microseconds; });
        std::string path;
        for (Rung const* const rung : on) {
            path += fmt::format("{}{:.1f},{:.1f} ", path.empty() ? "M" : "L", x(*rung), y(*rung));
        }
        if (on.size() > 1) {
            text_ +=
                fmt::format("<path d='{}' stroke='{}' stroke-width='2' fill='none'/>\n", path, frontColour);
        }
    }
    // Dots are numbered, with the names in a list at the side, because names beside the dots would overlap.
    void dots(Ladder const& ladder) {
        double line = top + 4;
        int number = 0;
        for (Rung const& rung : ladder.rungs) {
            ++number;
            bool const good = rung.onFront || !ladder.rivals;
            char const* const fill = good ? frontColour : "#faf6ec";
            char const* const stroke = good ? frontColour : restColour;
            // On alternate sides of the dots, because neighbours in the ladder are often close together in
            // the plot.
            double const side = number % 2 == 0 ? 14 : -6;
            text_ += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4.5' fill='{}' stroke='{}' "
                                 "stroke-width='2'/><text x='{:.1f}' y='{:.1f}' font-size='11' fill='{}' "
                                 "text-anchor='{}'>{}</text>\n",
                                 x(rung), y(rung), fill, stroke, x(rung) + (side > 0 ? 7 : -7),
                                 y(rung) + side, stroke, side > 0 ? "start" : "end", number);
            text_ += fmt::format("<text x='{:.1f}' y='{:.1f}' fill='{}' text-anchor='end'>{}</text>"
                                 "<text x='{:.1f}' y='{:.1f}'>{}</text>\n",
                                 legend, line, stroke, number, legend + 8, line, escaped(rung.level));
            line += 20;
        }
        if (ladder.rivals) {
            text_ += fmt::format("<text x='{:.1f}' y='{:.1f}' fill='{}'>blue: the front</text>\n", legend + 8,
                                 line + 12, frontColour);
        }
    }

    Axis x_;
    Axis y_;
    bool exact_;
    std::string text_;
};

} // namespace

std::string asSvg(Ladder const& ladder) {
    return Picture(ladder).text();
}

} // namespace trembler::accuracy
