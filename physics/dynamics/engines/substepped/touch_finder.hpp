// Finds contacts with Box2D's dynamic tree and collision routines: for engines whose own contacts of polygons
// are incomplete.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <box2d/box2d.h>

#include <functional>

namespace trembler {

/// Two pieces that touch, including their skins.
struct FoundTouch {
    std::uint64_t key = 0; ///< see pieceKey()
    SlotIndex a = noSlot;
    SlotIndex b = noSlot;
    Vec2 normal;                 ///< unit, from a to b
    std::array<Vec2, 2> points;  ///< m, in the world
    std::array<double, 2> depth; ///< m, overlap of the skins
    int count = 0;
};

class TouchFinder {
public:
    using Filter = std::function<bool(SlotIndex, SlotIndex)>;

    /// Box2D's unit of length is 1/`scale` m, which makes the skins of polygons 0.01/`scale` m thick.
    explicit TouchFinder(double scale) : scale_(scale) {}

    void add(SlotIndex slot, BodySpec const& spec);
    void remove(SlotIndex slot);
    void place(SlotIndex slot, Vec2 centre, double angle);

    /// Appends the contacts of the pieces of the bodies in `slots`, each slot once, each pair of pieces once,
    /// ascending by key. `mayTouch` is called with the smaller slot first.
    void find(std::span<SlotIndex const> slots, Filter const& mayTouch, std::vector<FoundTouch>& found);
    /// The share of the path `way` (m) that a disc can move from `start` before it hits a body for which
    /// `stops` returns true; 1 if it hits none or overlaps one already.
    [[nodiscard]] double freeShare(Vec2 start, double radius, Vec2 way,
                                   std::function<bool(SlotIndex)> const& stops) const;

private:
    struct Piece {
        std::uint32_t name = 0;
        std::unique_ptr<b2Shape> shape;
        std::int32_t proxy = 0;
        b2AABB box;
    };
    struct Entry {
        b2Transform at;
        std::vector<std::unique_ptr<Piece>> pieces;
    };

    [[nodiscard]] b2Vec2 toBox2d(Vec2 v) const {
        return {static_cast<float>(v.x * scale_), static_cast<float>(v.y * scale_)};
    }
    void follow(Entry& entry);
    [[nodiscard]] bool meet(Piece const& a, Piece const& b, FoundTouch& touch) const;

    double scale_;
    b2DynamicTree tree_;
    std::vector<Entry> entries_; // by slot
    struct Near {
        std::uint64_t key = 0;
        Piece const* a = nullptr;
        Piece const* b = nullptr;
    };
    // Members to reuse their memory.
    std::vector<Near> near_;
    std::vector<std::uint8_t> searched_; // by slot: one of those given to find()
};

} // namespace trembler
