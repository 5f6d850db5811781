#include "render/panels/toasts.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace trembler::render {

namespace {

using namespace palette;

constexpr std::size_t mostToasts = 5;
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

/// A rectangle of the window, pixels.
struct Box {
    ImVec2 low;
    ImVec2 high;

    [[nodiscard]] bool overlaps(Box const& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
};

struct ToastPlace {
    Box box;
    float textWidth; ///< at which its lines are broken
};

/// The middle of the window, and those between any two edges of the rectangles.
std::vector<float> middlesBetween(std::span<Box const> taken, float screen) {
    std::vector<float> middles{0.5F * screen};
    std::vector<float> edges{0, screen};
    for (Box const& box : taken) {
        edges.push_back(box.low.x);
        edges.push_back(box.high.x);
    }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            middles.push_back(0.5F * (edges[i] + edges[j]));
        }
    }
    return middles;
}

/// The place of which the lower edge is highest; in the middle of the window if all are equal, or if there is
/// none.
ToastPlace placeOf(std::string const& words, std::span<Box const> taken) {
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    float const edge = scaled(8);
    std::vector<float> const middles = middlesBetween(taken, screen.x);
    std::vector<float> tops{scaled(18)};
    for (Box const& box : taken) {
        tops.push_back(box.high.y + scaled(toastGap));
    }
    std::optional<ToastPlace> best;
    std::optional<ToastPlace> usual;
    for (float const share : {0.4F, 0.28F, 0.2F, 0.14F}) {
        float const most = share * screen.x;
        ImVec2 const text = ImGui::CalcTextSize(words.c_str(), nullptr, false, most);
        ImVec2 const size{text.x + scaled(markSize) + 3 * scaled(paddingSize),
                          std::max(text.y, scaled(markSize)) + 2 * scaled(10)};
        for (float const middle : middles) {
            for (float const top : tops) {
                Box const box{{middle - 0.5F * size.x, top}, {middle + 0.5F * size.x, top + size.y}};
                usual = usual ? usual : ToastPlace{box, most};
                bool const inside = box.low.x >= edge && box.high.x <= screen.x - edge && box.low.y >= 0 &&
                                    box.high.y <= screen.y - edge;
                bool const better = !best || box.high.y < best->box.high.y - 1;
                if (inside && better && std::none_of(taken.begin(), taken.end(), [&](Box const& other) {
                        return box.overlaps(other);
                    })) {
                    best = ToastPlace{box, most};
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
    toasts_.push_back({std::move(text), kind, std::clamp(seconds, 0.5, 60.0), 0});
}

void Toasts::draw(double seconds, std::span<Rectangle const> kept) {
    auto& list = *ImGui::GetForegroundDrawList();
    std::vector<Box> taken;
    for (auto const& [low, high] : kept) {
        taken.push_back({{static_cast<float>(low.x), static_cast<float>(low.y)},
                         {static_cast<float>(high.x), static_cast<float>(high.y)}});
    }
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
        float const width = place.high.x - place.low.x;
        float const height = place.high.y - place.low.y;
        taken.push_back({place.low, {place.high.x, place.low.y + shown * (height + scaled(toastGap))}});
        ImVec2 const low = place.low;
        ImVec2 const high{low.x + width, low.y + height};
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
