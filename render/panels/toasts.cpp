#include "render/panels/toasts.hpp"

#include "render/draw/palette.hpp"
#include "render/panels/icons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <utility>

namespace trembler::render {

namespace {

using namespace palette;

constexpr std::size_t mostToasts = 5;
constexpr double fadeSeconds = 0.25;

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

} // namespace

void Toasts::add(std::string text, ToastKind kind, double seconds) {
    troubles_ += kind == ToastKind::Trouble ? 1 : 0;
    if (toasts_.size() == mostToasts) {
        toasts_.pop_front();
    }
    toasts_.push_back({std::move(text), kind, std::clamp(seconds, 0.5, 60.0), 0});
}

void Toasts::draw(double seconds, std::optional<Rectangle> kept) {
    auto& list = *ImGui::GetForegroundDrawList();
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    float y = scaled(18);
    ImGui::PushFont(theme().fonts.strong);
    for (auto& toast : toasts_) {
        toast.age += seconds;
        toast.left -= seconds;
        auto const shown =
            static_cast<float>(std::clamp(std::min(toast.age, toast.left) / fadeSeconds, 0.0, 1.0));
        auto const [colour, icon] = lookOf(toast.kind);
        float const most = 0.4F * screen.x; // fits between the goals and the buttons at the top
        ImVec2 const text = ImGui::CalcTextSize(toast.text.c_str(), nullptr, false, most);
        float const mark = scaled(26);
        float const padding = scaled(13);
        float const width = text.x + mark + 3 * padding;
        float const height = std::max(text.y, mark) + 2 * scaled(10);
        float const left = 0.5F * (screen.x - width);
        float highest = 0; // where it may begin while it comes down
        if (kept && left < static_cast<float>(kept->second.x) &&
            left + width > static_cast<float>(kept->first.x) && y < static_cast<float>(kept->second.y) &&
            y + height > static_cast<float>(kept->first.y)) {
            highest = static_cast<float>(kept->second.y) + scaled(4);
            y = static_cast<float>(kept->second.y) + scaled(10);
        }
        ImVec2 const low{left, std::max(y - (1 - shown) * scaled(14), highest)};
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
        y += (height + scaled(10)) * shown;
    }
    ImGui::PopFont();
    std::erase_if(toasts_, [](Toast const& toast) { return toast.left <= 0; });
}

} // namespace trembler::render
