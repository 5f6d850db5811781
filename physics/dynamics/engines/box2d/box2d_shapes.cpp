#include "physics/dynamics/engines/box2d/box2d_shapes.hpp"

namespace trembler {
namespace {

// Converts the pieces of one object to Box2D shapes.
class ShapeMaker {
public:
    ShapeMaker(BodySpec const& spec, double scale, std::function<void(b2Shape const&)> const& take)
        : spec_(spec), scale_(scale), take_(take) {}

    void add(ShapePiece const& piece) {
        switch (piece.form) {
        case ShapeForm::circle:
            addCircle(piece.at, piece.radius);
            return;
        case ShapeForm::box:
            addBox(piece, piece.width, piece.height);
            return;
        case ShapeForm::polygon:
            addPolygon(piece, piece.corners);
            return;
        case ShapeForm::capsule: {
            double const half = piece.width / 2 - piece.radius;
            if (2 * half >= shortest) {
                addBox(piece, 2 * half, 2 * piece.radius);
            }
            Vec2 const end = rotated({half, 0}, piece.angle);
            addCircle(piece.at - end, piece.radius);
            addCircle(piece.at + end, piece.radius);
            return;
        }
        }
    }

private:
    // The shortest straight part of a capsule that gets a shape of its own, m.
    static constexpr double shortest = 0.005;

    [[nodiscard]] b2Vec2 inBody(Vec2 point) const {
        Vec2 const v = point - spec_.spread.centre;
        return {static_cast<float>(v.x * scale_), static_cast<float>(v.y * scale_)};
    }
    void addCircle(Vec2 at, double radius) {
        b2CircleShape circle;
        circle.m_p = inBody(at);
        circle.m_radius = static_cast<float>(radius * scale_);
        take_(circle);
    }
    void addBox(ShapePiece const& piece, double width, double height) {
        b2PolygonShape box;
        if (piece.angle == 0 && piece.at == spec_.spread.centre) {
            box.SetAsBox(static_cast<float>(width / 2 * scale_), static_cast<float>(height / 2 * scale_));
        } else {
            box.SetAsBox(static_cast<float>(width / 2 * scale_), static_cast<float>(height / 2 * scale_),
                         inBody(piece.at), static_cast<float>(piece.angle));
        }
        take_(box);
    }
    // Set() would compute the convex hull again, and abort where single precision gives another result; these
    // corners are known to be convex and anticlockwise.
    void addPolygon(ShapePiece const& piece, std::vector<Vec2> const& corners) {
        b2PolygonShape polygon;
        polygon.m_count = static_cast<int32>(corners.size());
        b2Vec2 sum = b2Vec2_zero;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            polygon.m_vertices[i] = inBody(piece.at + rotated(corners[i], piece.angle));
            Vec2 const side = rotated(corners[(i + 1) % corners.size()] - corners[i], piece.angle);
            Vec2 const normal = -perpendicular(side) / length(side);
            polygon.m_normals[i] = {static_cast<float>(normal.x), static_cast<float>(normal.y)};
            sum += polygon.m_vertices[i];
        }
        polygon.m_centroid = (1.0F / static_cast<float>(corners.size())) * sum;
        take_(polygon);
    }

    BodySpec const& spec_;
    double scale_;
    std::function<void(b2Shape const&)> const& take_;
};

} // namespace

void makeShapes(BodySpec const& spec, double scale, std::function<void(b2Shape const&)> const& take) {
    ShapeMaker maker(spec, scale, take);
    for (ShapePiece const& piece : spec.shape->pieces) {
        maker.add(piece);
    }
}

} // namespace trembler
