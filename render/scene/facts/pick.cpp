#include "render/scene/facts/pick.hpp"

#include "render/scene/facts/drawn_copies.hpp"
#include "render/scene/facts/look_form.hpp"

#include <algorithm>

namespace trembler::render {

double distanceTo(Facts const& facts, Pose const& pose, Point at) {
    if (facts.shape != nullptr) {
        return distanceTo(*facts.shape, toLocal(pose, at));
    }
    return length(at - pose.at) - symbolRadius;
}

ObjectId pick(World const& world, Point at, double tolerance) {
    std::vector<Facts> const all = FactsReader(world).drawOrder();
    ObjectId nearest;
    double least = tolerance;
    for (std::size_t i = all.size(); i-- > 0;) { // from the top
        double const distance = distanceTo(all[i], poseOf(all[i]), at);
        if (distance <= 0) {
            return all[i].id;
        }
        if (distance < least || (distance == least && !nearest.valid())) {
            least = distance;
            nearest = all[i].id;
        }
    }
    return nearest;
}

Extent extentOf(Facts const& facts, Pose const& pose) {
    Extent around;
    if (facts.shape != nullptr) {
        around = extentOf(*facts.shape, pose);
    } else if (facts.symbolOnly()) {
        around.add(pose.at);
        around = around.widened(symbolRadius);
    }
    return around;
}

std::vector<Extent> extentsOf(World const& world) {
    std::vector<Extent> all;
    for (Facts const& facts : FactsReader(world).drawOrder()) {
        if (Extent const own = extentOf(facts, poseOf(facts)); !own.empty()) {
            all.push_back(own);
        }
    }
    return all;
}

Extent pictureExtentOf(Facts const& facts, Pose const& pose) {
    Extent around = extentOf(facts, pose);
    if (facts.drawing != nullptr) {
        for (DrawnShape const& shape : facts.drawing->shapes) {
            for (std::int32_t copy = 0; copy < shape.repeat && isShown(shape.when, facts); ++copy) {
                Pose const own = poseOfCopy(shape, copy);
                Extent const drawn = extentOf(shape, {toWorld(pose, own.at), pose.angle + own.angle});
                around.add(drawn.widened(shape.glow));
            }
        }
    }
    return around;
}

Extent extentOf(Prototype const& prototype, Pose const& pose) {
    return extentOf(factsOf(prototype), pose);
}

Extent sceneFocus(World const& world, Extent const& bounds) {
    std::vector<Facts> all = FactsReader(world).drawOrder();
    std::erase_if(all, [&](Facts const& facts) {
        return !bounds.empty() && !facts.fixed && !extentOf(facts, poseOf(facts)).overlaps(bounds);
    });
    auto const size = [](Extent const& extent) { return std::max(extent.half().x, extent.half().y); };
    Extent rest;
    double largest = 0;
    for (Facts const& facts : all) {
        Extent const own = extentOf(facts, poseOf(facts));
        // Fixed bodies that are not larger than the moving ones are part of the scene like any other.
        if (!facts.fixed) {
            rest.add(own);
            largest = own.empty() ? largest : std::max(largest, size(own));
        }
    }
    for (Facts const& facts : all) {
        Extent const own = extentOf(facts, poseOf(facts));
        if (facts.fixed && !own.empty() && (rest.empty() || size(own) <= 2 * std::max(largest, 1.0))) {
            rest.add(own);
        }
    }
    Extent const around = rest.widened(0.5 * (rest.empty() ? 0 : size(rest)) + 0.5);
    for (Facts const& facts : all) {
        Extent const own = extentOf(facts, poseOf(facts));
        if (!own.empty() && own.overlaps(around)) {
            rest.add(Point{std::clamp(own.lower.x, around.lower.x, around.upper.x),
                           std::clamp(own.lower.y, around.lower.y, around.upper.y)});
            rest.add(Point{std::clamp(own.upper.x, around.lower.x, around.upper.x),
                           std::clamp(own.upper.y, around.lower.y, around.upper.y)});
        }
    }
    return rest;
}

} // namespace trembler::render
