#include "runtime/level/property/move_property.hpp"

#include <utility>

namespace trembler {
namespace {

/// Moves every field that it visits.
class FieldMover final : public FieldVisitor {
public:
    FieldMover(PieceFrame const& outer, bool mirror)
        : outer_(outer), mirror_(mirror), odd_(mirror != outer.flipped) {}

    void boolean(FieldInfo const&, bool&) override {}
    void integer(FieldInfo const&, std::int32_t&) override {}
    void text(FieldInfo const&, std::string&) override {}
    void object(FieldInfo const&, ObjectId&) override {}
    void choice(FieldInfo const&, ChoiceField) override {}

    void number(FieldInfo const& info, double& value) override {
        switch (info.geometry) {
        case FieldGeometry::turning:
            value = odd_ ? PieceFrame::negative(value) : value;
            break;
        case FieldGeometry::turningLower:
            lower_ = &value;
            exchangeLimits();
            break;
        case FieldGeometry::turningUpper:
            upper_ = &value;
            exchangeLimits();
            break;
        case FieldGeometry::heading:
            value = outer_.heading(value);
            break;
        default:
            break;
        }
    }
    void vector(FieldInfo const& info, Vec2& value) override {
        Vec2 const own = mirror_ ? PieceFrame::mirrored(value) : value;
        switch (info.geometry) {
        case FieldGeometry::ownVector:
        case FieldGeometry::ownOutline:
            value = odd_ ? PieceFrame::mirrored(value) : value;
            break;
        case FieldGeometry::worldPoint:
            value = outer_.point(value);
            break;
        case FieldGeometry::worldVector:
            value = outer_.direction(own);
            break;
        case FieldGeometry::worldAxis: {
            Vec2 const turned = outer_.direction(own);
            value = odd_ ? Vec2{PieceFrame::negative(turned.x), PieceFrame::negative(turned.y)} : turned;
            break;
        }
        default:
            break;
        }
    }
    void list(FieldInfo const& info, ListField& field) override {
        std::size_t const size = field.size();
        for (std::size_t i = 0; i < size; ++i) {
            FieldMover element(outer_, mirror_); // limits belong together within one element
            field.visitElement(i, element);
        }
        if (odd_ && info.geometry == FieldGeometry::ownOutline) {
            reverse(field);
        }
    }

private:
    /// Once both have been visited.
    void exchangeLimits() {
        if (odd_ && lower_ != nullptr && upper_ != nullptr) {
            double const lower = *lower_;
            *lower_ = PieceFrame::negative(*upper_);
            *upper_ = PieceFrame::negative(lower);
        }
    }
    /// The first corner stays the first, so that mirroring twice changes nothing.
    static void reverse(ListField& field) {
        for (std::size_t i = 1, j = field.size(); i + 1 < j; ++i) {
            --j;
            Swapper first(nullptr);
            field.visitElement(i, first);
            Swapper last(first.value);
            field.visitElement(j, last);
        }
    }
    /// Finds the vector of a list's element; exchanges it with one found before.
    class Swapper final : public FieldVisitor {
    public:
        explicit Swapper(Vec2* other) : value(other) {}
        Vec2* value;

        void boolean(FieldInfo const&, bool&) override {}
        void integer(FieldInfo const&, std::int32_t&) override {}
        void number(FieldInfo const&, double&) override {}
        void text(FieldInfo const&, std::string&) override {}
        void object(FieldInfo const&, ObjectId&) override {}
        void choice(FieldInfo const&, ChoiceField) override {}
        void list(FieldInfo const&, ListField&) override {}
        void vector(FieldInfo const&, Vec2& found) override {
            if (value == nullptr) {
                value = &found;
            } else {
                std::swap(*value, found);
            }
        }
    };

    PieceFrame const& outer_;
    bool mirror_;
    bool odd_; ///< whether the result is a mirror image
    double* lower_ = nullptr;
    double* upper_ = nullptr;
};

} // namespace

void moveProperty(PropertyValue& value, PieceFrame const& outer, bool mirror) {
    FieldMover mover(outer, mirror);
    value.visit(mover);
}

} // namespace trembler
