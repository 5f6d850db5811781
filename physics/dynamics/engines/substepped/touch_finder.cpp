#include "physics/dynamics/engines/substepped/touch_finder.hpp"

#include "physics/dynamics/engines/box2d/box2d_shapes.hpp"
#include "physics/dynamics/engines/substepped/touch_record.hpp"

#include <box2d/b2_distance.h>

#include <algorithm>

namespace trembler {
namespace {

std::unique_ptr<b2Shape> copyOf(b2Shape const& shape) {
    if (shape.GetType() == b2Shape::e_circle) {
        return std::make_unique<b2CircleShape>(static_cast<b2CircleShape const&>(shape));
    }
    return std::make_unique<b2PolygonShape>(static_cast<b2PolygonShape const&>(shape));
}

// Adapter that makes b2DynamicTree::Query() visit all proxies.
template <class Visitor>
struct TreeQuery {
    Visitor visit;
    bool QueryCallback(int32 proxy) { // NOLINT(readability-identifier-naming): Box2D calls it so
        visit(proxy);
        return true;
    }
};
template <class Visitor>
TreeQuery(Visitor) -> TreeQuery<Visitor>; // clang 14 has none for aggregates

} // namespace

void TouchFinder::add(SlotIndex slot, BodySpec const& spec) {
    if (entries_.size() <= slot) {
        entries_.resize(slot + std::size_t{1});
    }
    Entry& entry = entries_[slot];
    entry.at.Set(toBox2d(spec.motion.centre), static_cast<float>(spec.motion.angle));
    makeShapes(spec, scale_, [&](b2Shape const& shape) {
        auto piece = std::make_unique<Piece>();
        piece->name = pieceName(slot, entry.pieces.size());
        piece->shape = copyOf(shape);
        piece->shape->ComputeAABB(&piece->box, entry.at, 0);
        piece->proxy = tree_.CreateProxy(piece->box, piece.get());
        entry.pieces.push_back(std::move(piece));
    });
}

void TouchFinder::remove(SlotIndex slot) {
    for (auto const& piece : entries_[slot].pieces) {
        tree_.DestroyProxy(piece->proxy);
    }
    entries_[slot].pieces.clear();
}

void TouchFinder::place(SlotIndex slot, Vec2 centre, double angle) {
    entries_[slot].at.Set(toBox2d(centre), static_cast<float>(angle));
    follow(entries_[slot]);
}

void TouchFinder::follow(Entry& entry) {
    for (auto const& piece : entry.pieces) {
        piece->shape->ComputeAABB(&piece->box, entry.at, 0);
        tree_.MoveProxy(piece->proxy, piece->box, b2Vec2_zero);
    }
}

bool TouchFinder::meet(Piece const& a, Piece const& b, FoundTouch& touch) const {
    // Box2D's routines expect the polygon first.
    bool const swapped = a.shape->GetType() == b2Shape::e_circle && b.shape->GetType() != b2Shape::e_circle;
    Piece const& first = swapped ? b : a;
    Piece const& second = swapped ? a : b;
    b2Transform const& atFirst = entries_[slotOfPiece(first.name)].at;
    b2Transform const& atSecond = entries_[slotOfPiece(second.name)].at;
    b2Manifold manifold;
    if (first.shape->GetType() == b2Shape::e_circle) {
        b2CollideCircles(&manifold, static_cast<b2CircleShape const*>(first.shape.get()), atFirst,
                         static_cast<b2CircleShape const*>(second.shape.get()), atSecond);
    } else if (second.shape->GetType() == b2Shape::e_circle) {
        b2CollidePolygonAndCircle(&manifold, static_cast<b2PolygonShape const*>(first.shape.get()), atFirst,
                                  static_cast<b2CircleShape const*>(second.shape.get()), atSecond);
    } else {
        b2CollidePolygons(&manifold, static_cast<b2PolygonShape const*>(first.shape.get()), atFirst,
                          static_cast<b2PolygonShape const*>(second.shape.get()), atSecond);
    }
    if (manifold.pointCount == 0) {
        return false;
    }
    b2WorldManifold world;
    world.Initialize(&manifold, atFirst, first.shape->m_radius, atSecond, second.shape->m_radius);
    touch.key = pieceKey(a.name, b.name);
    touch.a = slotOfPiece(a.name);
    touch.b = slotOfPiece(b.name);
    Vec2 const normal{static_cast<double>(world.normal.x), static_cast<double>(world.normal.y)};
    touch.normal = (swapped ? -1 : 1) / length(normal) * normal;
    touch.count = manifold.pointCount;
    for (int i = 0; i < manifold.pointCount; ++i) {
        auto const n = static_cast<std::size_t>(i);
        touch.points[n] = {static_cast<double>(world.points[i].x) / scale_,
                           static_cast<double>(world.points[i].y) / scale_};
        touch.depth[n] = -static_cast<double>(world.separations[i]) / scale_;
    }
    return true;
}

void TouchFinder::find(std::span<SlotIndex const> slots, Filter const& mayTouch,
                       std::vector<FoundTouch>& found) {
    near_.clear();
    searched_.assign(entries_.size(), 0);
    for (SlotIndex const slot : slots) {
        searched_[slot] = 1;
    }
    for (SlotIndex const slot : slots) {
        for (auto const& piece : entries_[slot].pieces) {
            TreeQuery query{[&](int32 proxy) {
                auto const* const other = static_cast<Piece const*>(tree_.GetUserData(proxy));
                SlotIndex const otherSlot = slotOfPiece(other->name);
                bool const fromOther = searched_[otherSlot] != 0 && otherSlot < slot;
                if (otherSlot != slot && !fromOther && b2TestOverlap(piece->box, other->box) &&
                    mayTouch(std::min(slot, otherSlot), std::max(slot, otherSlot))) {
                    Piece const* const own = piece.get();
                    bool const first = own->name < other->name;
                    near_.push_back(
                        {pieceKey(first ? own->name : other->name, first ? other->name : own->name),
                         first ? own : other, first ? other : own});
                }
            }};
            tree_.Query(&query, piece->box);
        }
    }
    std::sort(near_.begin(), near_.end(), [](Near const& x, Near const& y) { return x.key < y.key; });
    for (Near const& pair : near_) {
        FoundTouch touch;
        if (meet(*pair.a, *pair.b, touch)) {
            found.push_back(touch);
        }
    }
}

double TouchFinder::freeShare(Vec2 start, double radius, Vec2 way,
                              std::function<bool(SlotIndex)> const& stops) const {
    b2CircleShape disc;
    disc.m_p = b2Vec2_zero;
    disc.m_radius = static_cast<float>(radius * scale_);
    b2Transform at;
    at.Set(toBox2d(start), 0);
    b2Transform end;
    end.Set(toBox2d(start + way), 0);
    b2AABB box;
    b2AABB boxAtEnd;
    disc.ComputeAABB(&box, at, 0);
    disc.ComputeAABB(&boxAtEnd, end, 0);
    box.Combine(boxAtEnd);
    double share = 1;
    TreeQuery query{[&](int32 proxy) {
        auto const* const piece = static_cast<Piece const*>(tree_.GetUserData(proxy));
        SlotIndex const slot = slotOfPiece(piece->name);
        if (!b2TestOverlap(box, piece->box) || !stops(slot)) {
            return;
        }
        if (piece->shape->TestPoint(entries_[slot].at, at.p)) {
            return; // b2ShapeCast may report a hit at the beginning of the path
        }
        b2ShapeCastInput input;
        input.proxyA.Set(piece->shape.get(), 0);
        input.proxyB.Set(&disc, 0);
        input.transformA = entries_[slot].at;
        input.transformB = at;
        input.translationB = toBox2d(way);
        b2ShapeCastOutput output;
        if (b2ShapeCast(&output, &input)) {
            share = std::min(share, static_cast<double>(output.lambda));
        }
    }};
    tree_.Query(&query, box);
    return share;
}

} // namespace trembler
