#include "render/scene/overlays/overlay_electricity.hpp"

#include "render/scene/facts/look_form.hpp"
#include "render/scene/facts/poses.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/marks/dashes.hpp"
#include "render/scene/marks/signs.hpp"

#include <array>

namespace trembler::render {
namespace {

Point vertexOf(Facts const& facts, Pose const& pose) {
    return facts.shape == nullptr ? pose.at : toWorld(pose, extentOf(*facts.shape, {}).centre());
}

void drawEdge(Canvas& canvas, Link const& link, Point a, Point b) {
    bool const wire = link.counts.of(CallerId::level()) > 0;
    Stroke stroke{.colour = link.live ? palette::live : palette::inkSoft,
                  .pixels = link.live ? 6.F : 3.F,
                  .outline = link.live ? 1.4F : 0.F,
                  .outlineColour = palette::ink};
    if (link.live) {
        stroke.glow = {palette::live, canvas.metres(9), 0.8F};
    }
    std::array const ends{a, b};
    if (wire) {
        canvas.polyline(ends, stroke);
    } else {
        dashed(canvas, ends, false, canvas.metres(9), canvas.metres(6), stroke);
    }
    Point const along = b - a;
    if (link.live && length(along) > canvas.metres(60)) {
        Point const unit = ((link.forward ? 1 : -1) / length(along)) * along;
        Point const middle = 0.5 * (a + b);
        canvas.arrow(middle - canvas.metres(9) * unit, middle + canvas.metres(11) * unit,
                     {.colour = palette::ink, .pixels = 3.6F});
    }
}

void drawVertex(Canvas& canvas, Facts const& facts, Point at) {
    Style const disc{.outline = 1.8F, .height = 0.F};
    double const large = canvas.metres(13);
    if (auto const sign = signOf(facts)) {
        drawBadge(canvas, signUnderLabel(facts, *sign), {at, 0}, large, facts.on, disc);
    } else {
        Style dot = disc;
        dot.tint = facts.on ? palette::live : palette::paperLight;
        if (facts.on) {
            dot.glow = {palette::live, canvas.metres(8), 0.8F};
        }
        canvas.circle({at, 0}, canvas.metres(7), dot);
    }
}

} // namespace

void drawVeil(Canvas& canvas, float alpha) {
    Extent const view = viewOf(canvas.camera());
    canvas.box({view.centre(), 0}, 1.2 * view.half(), 0,
               {.tint = palette::paper, .outline = 0.F, .alpha = alpha, .height = 0.F});
}

void drawElectricity(Canvas& canvas, FactsReader const& reader, std::vector<Link> const& links,
                     PoseOf const& poseOf) {
    drawVeil(canvas, 0.5F);
    Extent const view = viewOf(canvas.camera()).widened(canvas.metres(30));
    for (Link const& link : links) {
        Facts const a = reader.of(link.a);
        Facts const b = reader.of(link.b);
        if (!a.visible() || !b.visible()) {
            continue;
        }
        Point const from = vertexOf(a, poseOf(a));
        Point const to = vertexOf(b, poseOf(b));
        Extent around;
        around.add(from);
        around.add(to);
        if (around.overlaps(view)) {
            drawEdge(canvas, link, from, to);
        }
    }
    for (Facts const& facts : reader.drawOrder()) {
        if (!facts.conductor && !facts.source && !facts.earth) {
            continue;
        }
        Point const at = vertexOf(facts, poseOf(facts));
        if (view.contains(at)) {
            drawVertex(canvas, facts, at);
        }
    }
}

} // namespace trembler::render
