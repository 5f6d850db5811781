// Every property states the geometry of its vectors and angles, so that any object can be mirrored.
#include "lua/attach/register.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/property/property_value.hpp"
#include "runtime/world/registry.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace trembler {
namespace geometry_test {
namespace {

/// Collects the fields that must state a geometry and do not. Fields can depend on a choice: of each struct,
/// the first choice is set to every one of its values in turn.
class Forgotten final : public FieldVisitor {
public:
    explicit Forgotten(int pretended) : pretended_(pretended) {}

    std::vector<std::string> keys;
    std::size_t seen = 0;
    std::size_t most = 0; ///< values of any choice

    void boolean(FieldInfo const&, bool&) override {}
    void integer(FieldInfo const&, std::int32_t&) override {}
    void text(FieldInfo const&, std::string&) override {}
    void object(FieldInfo const&, ObjectId&) override {}
    void choice(FieldInfo const&, ChoiceField field) override {
        most = std::max(most, field.names.size());
        if (pretended_ < static_cast<int>(field.names.size())) {
            field.index = pretended_;
        }
    }
    void number(FieldInfo const& info, double&) override {
        if (isAngle(info.unit)) {
            look(info);
        }
    }
    void vector(FieldInfo const& info, Vec2&) override { look(info); }
    void list(FieldInfo const&, ListField& field) override {
        field.resize(1);
        field.visitElement(0, *this); // which may turn a choice
        field.visitElement(0, *this);
    }

private:
    void look(FieldInfo const& info) {
        ++seen;
        if (info.geometry == FieldGeometry::unstated) {
            keys.emplace_back(info.key);
        }
    }

    int pretended_;
};

TEST(Geometry, IsStatedByEveryVectorAndEveryAngleThatALevelCanState) {
    Registry registry;
    registerEffects(registry);
    lua::registerScripts(registry);
    std::size_t seen = 0;
    for (PropertyInfo const* const info : registry.objectProperties()) {
        if (info->text.place == PropertyPlace::hidden) {
            continue; // added from other properties when the world starts
        }
        std::size_t variants = 1;
        for (std::size_t i = 0; i < variants; ++i) {
            auto const value = info->makeValue();
            Forgotten fields(static_cast<int>(i));
            value->visit(fields); // sets the choices
            value->visit(fields);
            for (std::string const& key : fields.keys) {
                ADD_FAILURE() << info->text.key << ": '" << key << "' states no geometry";
            }
            variants = std::max(variants, fields.most);
            seen += fields.seen;
        }
    }
    EXPECT_GT(seen, 50U);
}

} // namespace
} // namespace geometry_test
} // namespace trembler
