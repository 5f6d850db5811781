// A world that follows a drag is the same as a world that is built from the level after the drag.
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/world/displacement.hpp"
#include "puzzle/edit/world/edited_world.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"
#include "tests/support/sanitizer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace trembler::edit {
namespace displacement_test {
namespace {

void expectNear(Vec2 a, Vec2 b, std::string const& what) {
    EXPECT_LT(length(a - b), 1e-6) << what << ": " << a.x << ", " << a.y << " and " << b.x << ", " << b.y;
}

double farthest(Shape const& shape) {
    auto const [low, high] = extentOf(PlacedShape{shape, {}, 0});
    return length(low) + length(high);
}

void expectSameScene(World const& followed, World const& built, std::string const& where) {
    ObjectTable const& all = built.store().objects();
    for (std::uint32_t number = 0; number < all.indexBound(); ++number) {
        std::string const name = built.store().nameOf(all.at(number));
        ObjectId const there = followed.store().find(name);
        ASSERT_TRUE(there.valid()) << where << name;
        if (auto const* const position = built.find<Position>(all.at(number))) {
            expectNear(followed.find<Position>(there)->value, position->value, where + name);
        }
        if (auto const* const rotation = built.find<Rotation>(all.at(number))) {
            EXPECT_NEAR(std::remainder(followed.find<Rotation>(there)->angle - rotation->angle, 2 * pi), 0,
                        1e-6)
                << where << name;
        }
        if (auto const* const shape = built.find<Shape>(all.at(number))) {
            EXPECT_NEAR(farthest(*followed.find<Shape>(there)), farthest(*shape), 1e-6) << where << name;
        }
        if (auto const* const joint = built.find<Joint>(all.at(number))) {
            Joint const& other = *followed.find<Joint>(there);
            expectNear(other.at, joint->at, where + name + " at");
            expectNear(other.atB, joint->atB, where + name + " at_b");
            expectNear(other.groundA, joint->groundA, where + name + " ground_a");
            expectNear(other.groundB, joint->groundB, where + name + " ground_b");
        }
    }
}

/// A level's document and the displayed world; each command is undone in both before the next.
class Followed {
public:
    explicit Followed(LevelDocument& document) : document_(document), tree_(document.tree()) {
        build(shown_);
        build(before_);
    }

    /// Whether the world follows a command; it is then compared with a world built from the changed level.
    bool follows(std::function<Command(Json const&)> const& make, std::string const& where) {
        try {
            document_.run(make(document_.tree()));
        } catch (CommandError const&) {
            return true; // such as locked objects
        }
        bool const followed = shown_.follow(document_.tree());
        if (followed) {
            EditedWorld after;
            build(after);
            expectSameScene(*shown_.world(), *after.world(), where);
        }
        document_.undo();
        EXPECT_EQ(document_.tree(), tree_) << where;
        if (followed) {
            EXPECT_TRUE(shown_.follow(document_.tree())) << "and back";
            expectSameScene(*shown_.world(), *before_.world(), where + "back: ");
        } else {
            build(shown_);
        }
        return followed;
    }

private:
    void build(EditedWorld& world) const {
        world.build(document_.data(), document_.level(), document_.tree());
    }

    LevelDocument& document_;
    Json const tree_;
    EditedWorld shown_;
    EditedWorld before_;
};

/// The same, with a world that has followed nothing before.
bool follows(LevelDocument& document, std::function<Command(Json const&)> const& make,
             std::string const& where) {
    return Followed(document).follows(make, where);
}

TEST(Displacement, ShowsWhatTheLevelsWouldShow) {
    for (auto const& path : editData().levels()) {
        LevelDocument document = LevelDocument::open(editData(), path);
        Followed followed(document);
        std::vector<std::string> const all = objectNames(document.tree());
        std::string const where = path.filename().string() + ": ";
        auto const moveOf = [](std::vector<std::string> const& names) {
            return [names](Json const& level) { return moveObjects(editData(), level, names, {0.3, -0.2}); };
        };
        EXPECT_TRUE(follows(document, moveOf(all), where)) << where;
        // Each object in turn; with a sanitizer each fifth, since a world is built for each.
        for (std::size_t i = 0; i < all.size(); i += test::underSanitizer ? 5 : 1) {
            EXPECT_TRUE(followed.follows(moveOf({all[i]}), where)) << where << all[i];
        }
        // An object that gets an angle for the first time is built again.
        follows(
            document,
            [&](Json const& level) {
                return rotateObjects(editData(), level, all, 30, {1, 1});
            },
            where);
    }
}

TEST(Displacement, FollowsSizes) {
    LevelDocument document = smallDocument();
    EXPECT_TRUE(follows(
        document,
        [](Json const& level) {
            return scaleObjects(editData(), level, {"left", "right"}, {2, 1}, {0, 0});
        },
        "scaled: "));
    EXPECT_TRUE(follows(
        document,
        [](Json const& level) {
            return rotateObjects(editData(), level, {"right"}, 30, {0, 0});
        },
        "turned: "));
}

TEST(Displacement, RefusesWhatIsNoPlaceOrSize) {
    LevelDocument document = smallDocument();
    EditedWorld world;
    world.build(editData(), document.level(), document.tree());
    document.run(setField(editData(), document.tree(), {"left"}, "mass", "", 3));
    EXPECT_FALSE(world.follow(document.tree()));
    document.undo();
    EXPECT_TRUE(world.follow(document.tree()));
    document.run(removeObjects(editData(), document.tree(), {"left"}));
    EXPECT_FALSE(world.follow(document.tree()));
}

} // namespace
} // namespace displacement_test
} // namespace trembler::edit
