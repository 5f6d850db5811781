#include "game/ui/play/view/cut_view.hpp"

#include "render/draw/palette.hpp"

#include <algorithm>
#include <span>

namespace trembler::ui {
namespace {

using namespace render;

/// One half hangs on to its own end: the nearer to the cut, the further it falls.
void drawHalf(Canvas& canvas, std::span<Point const> path, bool endFirst, double fallen, float alpha) {
    if (path.size() < 2) {
        return;
    }
    std::vector<Point> line(path.begin(), path.end());
    auto const last = static_cast<double>(line.size() - 1);
    for (std::size_t i = 0; i < line.size(); ++i) {
        double const share = endFirst ? static_cast<double>(i) / last : 1 - static_cast<double>(i) / last;
        line[i].y -= fallen * share * share;
    }
    canvas.polyline(line, {.colour = palette::ink, .pixels = 4, .alpha = alpha, .round = true});
}

} // namespace

void CutView::add(std::vector<Point> path) {
    constexpr std::size_t most = 8;
    if (path.size() >= 2 && cuts_.size() < most) {
        cuts_.push_back({std::move(path), 0});
    }
}

void CutView::pass(double seconds) {
    for (Cut& cut : cuts_) {
        cut.age += seconds;
    }
    std::erase_if(cuts_, [](Cut const& cut) { return cut.age > life; });
}

void CutView::draw(Canvas& canvas) const {
    for (Cut const& cut : cuts_) {
        auto const alpha = static_cast<float>(std::clamp(1 - cut.age / life, 0.0, 1.0));
        double const fallen = 1.6 * cut.age * cut.age;
        auto const half = cut.path.size() / 2;
        std::span<Point const> const path(cut.path);
        drawHalf(canvas, path.first(half + 1), true, fallen, alpha);
        drawHalf(canvas, path.subspan(half), false, fallen, alpha);
    }
}

} // namespace trembler::ui
