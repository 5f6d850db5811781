#include "render/panels/toasts.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"
#include "runtime/file/cut_text.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace trembler::render {

namespace {

using namespace palette;

constexpr std::size_t mostToasts = 5;
constexpr std::size_t mostBytes = 1000; // of one: about 25 lines
constexpr double fadeSeconds = 0.25;
// Pixels at UI scale 1.
constexpr float markSize = 26;
constexpr float paddingSize = 13;
constexpr float toastGap = 10;

std::pair<Colour, Icon> lookOf(ToastKind kind) {
    switch (kind) {
    case ToastKind::Success:
        return {goal, Icon::Tick};
    case ToastKind::Trouble:
        return {warning, Icon::Cross};
    case ToastKind::News:
        break;
    }
    return {accent, Icon::Next};
}

struct ToastPlace {
    Rect rect;
    float textWidth; ///< at which its lines are broken
};

double inPixels(float length) {
    return static_cast<double>(scaled(length));
}

/// The middle of the window, and those between any two edges of the rectangles.
std::vector<double> middlesBetween(std::span<Rect const> taken, double screen) {
    std::vector<double> middles{0.5 * screen};
    std::vector<double> edges{0, screen};
    for (Rect const& rect : taken) {
        edges.push_back(rect.low.x);
        edges.push_back(rect.high.x);
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            middles.push_back(0.5 * (edges[i] + edges[j]));
        }
    }
    return middles;
}

/// The size of a message with lines of at most that width.
Point sizeOf(std::string const& words, float most) {
    ImVec2 const text = ImGui::CalcTextSize(words.c_str(), nullptr, false, most);
    return {static_cast<double>(text.x) + inPixels(markSize) + 3 * inPixels(paddingSize),
            std::max(static_cast<double>(text.y), inPixels(markSize)) + 2 * inPixels(10)};
}

/// The place of which the lower edge is highest; in the middle of the window if all are equal, or if there is
/// none.
ToastPlace placeOf(std::string const& words, std::span<Rect const> taken) {
    ImVec2 const display = ImGui::GetIO().DisplaySize;
    Point const screen{static_cast<double>(display.x), static_cast<double>(display.y)};
    double const edge = inPixels(8);
    std::vector<double> const middles = middlesBetween(taken, screen.x);
    std::vector<double> tops{inPixels(18)};
    for (Rect const& rect : taken) {
        tops.push_back(rect.high.y + inPixels(toastGap));
    }
    std::optional<ToastPlace> best;
    std::optional<ToastPlace> usual;
    for (float const share : {0.4F, 0.28F, 0.2F, 0.14F}) {
        float const most = share * display.x;
        Point const size = sizeOf(words, most);
        for (double const middle : middles) {
            for (double const top : tops) {
                Rect const rect{{middle - 0.5 * size.x, top}, {middle + 0.5 * size.x, top + size.y}};
                usual = usual ? usual : ToastPlace{rect, most};
                bool const inside = rect.low.x >= edge && rect.high.x <= screen.x - edge && rect.low.y >= 0 &&
                                    rect.high.y <= screen.y - edge;
                bool const better = !best || rect.high.y < best->rect.high.y - 1;
                if (inside && better && std::none_of(taken.begin(), taken.end(), [&](Rect const& other) {
                        return rect.overlaps(other);
                    })) {
                    best = ToastPlace{rect, most};
                }
            }
        }
    }
    return best ? *best : *usual;
}

} // namespace

void Toasts::add(std::string text, ToastKind kind, double seconds) {
    troubles_ += kind == ToastKind::Trouble ? 1 : 0;
    if (toasts_.size() == mostToasts) {
        toasts_.pop_front();
    }
    toasts_.push_back({cutText(std::move(text), mostBytes), kind, std::clamp(seconds, 0.5, 60.0), 0});
}

void Toasts::draw(double seconds, std::span<Rect const> kept) {
    auto& list = *ImGui::GetForegroundDrawList();
    std::vector<Rect> taken(kept.begin(), kept.end());
    ImGui::PushFont(theme().fonts.strong);
    for (auto& toast : toasts_) {
        toast.age += seconds;
        toast.left -= seconds;
        auto const shown =
            static_cast<float>(std::clamp(std::min(toast.age, toast.left) / fadeSeconds, 0.0, 1.0));
        auto const [colour, icon] = lookOf(toast.kind);
        auto const [place, most] = placeOf(toast.text, taken);
        ImVec2 const text = ImGui::CalcTextSize(toast.text.c_str(), nullptr, false, most);
        float const mark = scaled(markSize);
        float const padding = scaled(paddingSize);
        // One that fades lets go of its room.
        double const height = place.high.y - place.low.y + inPixels(toastGap);
        taken.push_back({place.low, {place.high.x, place.low.y + static_cast<double>(shown) * height}});
        ImVec2 const low{static_cast<float>(place.low.x), static_cast<float>(place.low.y)};
        ImVec2 const high{static_cast<float>(place.high.x), static_cast<float>(place.high.y)};
        float const rounding = scaled(10);
        list.AddRectFilled({low.x, low.y + scaled(4)}, {high.x, high.y + scaled(4)},
                           imColour(faded(shadow, shown)), rounding);
        list.AddRectFilled(low, high, imColour(faded(paperLight, shown)), rounding);
        list.AddRect(low, high, imColour(faded(mix(colour, ink, 0.25F), shown)), rounding, 0, scaled(2));
        ImVec2 const centre{low.x + padding + 0.5F * mark, 0.5F * (low.y + high.y)};
        list.AddCircleFilled(centre, 0.5F * mark, imColour(faded(colour, shown)));
        drawIcon(list, icon, centre, 0.5F * mark, imColour(faded(paperLight, shown)));
        list.AddText(nullptr, 0, {low.x + 2 * padding + mark, 0.5F * (low.y + high.y - text.y)},
                     imColour(faded(ink, shown)), toast.text.c_str(), nullptr, most);
    }
    ImGui::PopFont();
    std::erase_if(toasts_, [](Toast const& toast) { return toast.left <= 0; });
}

} // namespace trembler::render
