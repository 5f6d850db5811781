// Parts give way a little when they are put down.
#pragma once

#include "puzzle/session/session.hpp"
#include "render/draw/canvas.hpp"

#include <vector>

namespace trembler::ui {

/// Compares placements from picture to picture; the last ones that were placed or moved are flattened for a
/// moment. Drawing only. Window thread only.
class SquashView {
public:
    /// For how long, s.
    static constexpr double life = 0.35;

    /// To be called once per picture, `seconds` after the last. Not `wanted`: nothing ever moves.
    void look(Session const& session, double seconds, bool wanted);

    [[nodiscard]] bool moving() const { return !numbers_.empty(); }
    /// The objects that are flattened now.
    [[nodiscard]] std::vector<ObjectId> objects(Session const& session) const;
    /// How much, about the middle of their lower edge.
    [[nodiscard]] render::Flattening flattening(Session const& session) const;

private:
    std::vector<PlacedPart> before_;
    bool known_ = false;       // before_ is of this level
    std::vector<int> numbers_; // of the parts
    double age_ = 0;
};

} // namespace trembler::ui
