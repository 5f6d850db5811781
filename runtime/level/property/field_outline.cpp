#include "runtime/level/property/field_outline.hpp"

#include <cmath>

namespace trembler {
namespace {

class Outliner final : public FieldVisitor {
public:
    std::vector<FieldOutline> fields;

    void boolean(FieldInfo const& info, bool&) override { fields.push_back({info, FieldType::boolean}); }
    void integer(FieldInfo const& info, std::int32_t&) override {
        fields.push_back({info, FieldType::integer});
    }
    void number(FieldInfo const& info, double&) override { fields.push_back({info, FieldType::number}); }
    void vector(FieldInfo const& info, Vec2&) override { fields.push_back({info, FieldType::vector}); }
    void text(FieldInfo const& info, std::string&) override { fields.push_back({info, FieldType::text}); }
    void object(FieldInfo const& info, ObjectId&) override { fields.push_back({info, FieldType::object}); }
    void choice(FieldInfo const& info, ChoiceField) override { fields.push_back({info, FieldType::choice}); }
    void list(FieldInfo const& info, ListField&) override { fields.push_back({info, FieldType::list}); }
};

} // namespace

std::vector<FieldOutline> outlineOf(PropertyValue& value) {
    Outliner outliner;
    value.visit(outliner);
    return std::move(outliner.fields);
}

bool isBare(std::vector<FieldOutline> const& fields) {
    return fields.size() == 1 && fields.front().info.key == "value";
}

bool isNumber(FieldOutline const& field) {
    return field.type == FieldType::integer || field.type == FieldType::number;
}

bool isAccuracySetting(FieldOutline const& field) {
    return isNumber(field) && field.info.accuracy.any();
}

bool isAngle(std::string_view unit) {
    return unit == "rad" || unit == "rad/s";
}

double radians(double degrees) {
    return degrees * (pi / 180);
}

double degrees(double radiansValue) {
    double const plain = radiansValue * (180 / pi);
    // The product may differ from the file's number by a rounding error. Choose the shortest number that
    // gives the same angle.
    for (int digits = 0; digits <= 17 && std::isfinite(plain); ++digits) {
        double const scale = std::pow(10.0, digits);
        double const round = std::round(plain * scale) / scale;
        if (radians(round) == radiansValue) {
            return round;
        }
    }
    for (double const near : {std::nextafter(plain, -INFINITY), std::nextafter(plain, INFINITY)}) {
        if (radians(near) == radiansValue) {
            return near;
        }
    }
    return plain;
}

} // namespace trembler
