#include "physics/dynamics/box2d/box2d_engine.hpp"

#include <array>

namespace trembler {
namespace {

// The pieces of one object, on their way into a body.
class FixtureMaker {
public:
    FixtureMaker(b2Body& body, BodySpec const& spec, double scale) : body_(body), spec_(spec), scale_(scale) {
        // The density stays 0: mass and moment are set for the body as a whole.
        fixture_.friction = static_cast<float>(spec.friction);
        fixture_.restitution = static_cast<float>(spec.restitution);
        fixture_.filter.categoryBits = static_cast<std::uint16_t>(spec.groups.category);
        fixture_.filter.maskBits = static_cast<std::uint16_t>(spec.groups.mask);
        fixture_.filter.groupIndex = static_cast<std::int16_t>(spec.groups.group);
    }

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
    static constexpr double shortest = 0.005; // m of a capsule's straight part that is worth a fixture

    [[nodiscard]] b2Vec2 inBody(Vec2 point) const {
        Vec2 const v = point - spec_.spread.centre;
        return {static_cast<float>(v.x * scale_), static_cast<float>(v.y * scale_)};
    }
    void addCircle(Vec2 at, double radius) {
        b2CircleShape circle;
        circle.m_p = inBody(at);
        circle.m_radius = static_cast<float>(radius * scale_);
        fixture_.shape = &circle;
        body_.CreateFixture(&fixture_);
    }
    void addBox(ShapePiece const& piece, double width, double height) {
        b2PolygonShape box;
        if (piece.angle == 0 && piece.at == spec_.spread.centre) {
            box.SetAsBox(static_cast<float>(width / 2 * scale_), static_cast<float>(height / 2 * scale_));
        } else {
            box.SetAsBox(static_cast<float>(width / 2 * scale_), static_cast<float>(height / 2 * scale_),
                         inBody(piece.at), static_cast<float>(piece.angle));
        }
        fixture_.shape = &box;
        body_.CreateFixture(&fixture_);
    }
    // Set() would look for the convex hull once more, and abort where single precision disagrees; these
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
        fixture_.shape = &polygon;
        body_.CreateFixture(&fixture_);
    }

    b2Body& body_;
    BodySpec const& spec_;
    double scale_;
    b2FixtureDef fixture_;
};

} // namespace

void addFixtures(b2Body& body, BodySpec const& spec, double scale) {
    FixtureMaker maker(body, spec, scale);
    for (ShapePiece const& piece : spec.shape->pieces) {
        maker.add(piece);
    }
}

} // namespace trembler
