// Pictures for people: every part, and every level before and after a run.
#include "physics/dynamics/properties/joint.hpp"
#include "physics/gravity/properties.hpp"
#include "render/scene/objects/body.hpp"
#include "render/scene/objects/part.hpp"
#include "render/scene/scene_view.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/render/scene/scene_stage.hpp"
#include "tests/support/sanitizer.hpp"

namespace trembler::render::test {
namespace {

std::filesystem::path const root = TREMBLER_SOURCE_DIR;

TEST(SceneGallery, EveryPart) {
    PartLibrary const library = loadParts(everything(), root / "assets" / "parts");
    Size const size{1600, 1800};
    Camera camera;
    camera.viewport = size;
    camera.fit({0, -18}, {16, 0}, 0);
    std::size_t drawn = 0;
    Image const sheet = picture(
        size, palette::paper,
        [&](Canvas& canvas) {
            canvas.paper();
            Point corner{0.3, -0.3}; // of the next part, upper left
            double row = 0;          // m, height of the highest part in the row
            for (PartDefinition const* part : library.all()) {
                Extent const own = extentOfPart(library, {part->name, {}, 0, ""});
                ASSERT_FALSE(own.empty()) << part->name;
                Point const half = own.half();
                if (corner.x + 2 * half.x > 15.7) {
                    corner = {0.3, corner.y - row - 0.35};
                    row = 0;
                }
                Point const at = corner + Point{half.x, -half.y} - own.centre();
                drawPart(canvas, library, {part->name, {at.x, at.y}, 0, ""});
                corner.x += 2 * half.x + 0.35;
                row = std::max(row, 2 * half.y);
                ++drawn;
            }
        },
        {}, camera);
    keepForPeople(sheet, "scene-parts");
    EXPECT_EQ(drawn, library.all().size());
}

// As in the toolbox: large enough to be distinguished without their names.
TEST(SceneGallery, CablesOnTheirTiles) {
    PartLibrary const library = loadParts(everything(), root / "assets" / "parts");
    std::vector<double> lows; // how deep the cable hangs, as a share of the part's width
    for (char const* const name : {"wire", "short wire"}) {
        Placement const placement{name, {}, 0, ""};
        Extent const extent = extentOnTile(library, placement);
        EXPECT_LT(extent.lower.y, extentOfPart(library, placement).lower.y) << name;
        lows.push_back(extent.half().y / extent.half().x);
        Camera camera{{}, 100, {160, 160}};
        camera.fit(extent.lower, extent.upper, 16);
        keepForPeople(picture(
                          {160, 160}, palette::paperLight,
                          [&](Canvas& canvas) { drawPartOnTile(canvas, library, placement); }, {}, camera),
                      "tile-" + std::string(name));
    }
    EXPECT_GT(lows[0], 0.3) << "it fills a good part of its tile";
    EXPECT_GT(lows[1], 0.3);
}

// A world with one of each kind of joint, after a second in which gravity has pulled at it.
TEST(SceneGallery, EveryJoint) {
    World world(everything());
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -9.81}});
    int count = 0;
    auto const named = [&](char const* kind) { return kind + std::to_string(count++); };
    auto const joint = [&](JointForm form, ObjectId a, Vec2 at, auto&& more) {
        Joint made;
        made.form = form;
        made.a = a;
        made.at = at;
        more(made);
        ObjectId const id = store.create(named("joint "));
        store.column<Joint>().set(id, made);
        return id;
    };
    auto const plain = [](Joint&) {};
    auto const moving = [&](std::vector<ShapePiece> pieces, Vec2 at, trembler::Material material) {
        ObjectId const id = body(world, named("body "), std::move(pieces), at);
        store.column<MadeOf>().set(id, {material});
        return id;
    };
    using M = trembler::Material;
    ObjectId const floor = body(world, "floor", {boxPiece(12, 0.4)}, {0, -2.9});
    ObjectId const ceiling = body(world, "ceiling", {boxPiece(12, 0.3)}, {0, 2.9});
    store.column<Fixed>().set(floor, {});
    store.column<Fixed>().set(ceiling, {});
    store.column<MadeOf>().set(floor, {M::stone});
    store.column<MadeOf>().set(ceiling, {M::wood});
    ObjectId const pendulum = moving({boxPiece(1.2, 0.14)}, {-4.6, 1.6}, M::wood);
    joint(JointForm::hinge, pendulum, {-5.1, 1.6}, plain);
    ObjectId const hung = moving({circlePiece(0.22)}, {-3.3, 0.6}, M::iron);
    joint(JointForm::rope, hung, {-3.3, 0.8}, [&](Joint& rope) {
        rope.b = ceiling;
        rope.atB = {-3.0, 2.75};
        rope.length = 2.4;
    });
    ObjectId const slack = moving({boxPiece(0.5, 0.3)}, {-2.0, -2.54}, M::wood);
    joint(JointForm::rope, slack, {-1.8, -2.45}, [&](Joint& rope) {
        rope.b = floor;
        rope.atB = {-0.6, -2.7};
        rope.length = 1.9;
        rope.collide = true;
    });
    ObjectId const bob = moving({boxPiece(0.4, 0.4)}, {-1.6, 1.0}, M::steel);
    joint(JointForm::spring, bob, {-1.6, 1.2}, [&](Joint& spring) {
        spring.b = ceiling;
        spring.atB = {-1.6, 2.75};
        spring.stiffness = 900;
        spring.dampingRate = 10;
    });
    ObjectId const left = moving({boxPiece(0.35, 0.35)}, {-0.3, 0.4}, M::stone);
    ObjectId const right = moving({boxPiece(0.3, 0.3)}, {1.3, 0.4}, M::stone);
    joint(JointForm::pulley, left, {-0.3, 0.55}, [&](Joint& pulley) {
        pulley.b = right;
        pulley.atB = {1.3, 0.55};
        pulley.groundA = {-0.18, 2.2};
        pulley.groundB = {1.18, 2.2};
    });
    ObjectId const carriage = moving({boxPiece(0.5, 0.24)}, {2.6, 2.0}, M::plastic);
    joint(JointForm::slider, carriage, {2.6, 2.0}, [](Joint& slider) {
        slider.axis = {1, -0.3};
        slider.limited = true;
        slider.lower = -0.3;
        slider.upper = 0.9;
    });
    ObjectId const rodEnd = moving({circlePiece(0.2)}, {4.8, 1.2}, M::copper);
    joint(JointForm::distance, rodEnd, {4.8, 1.2}, [&](Joint& rod) {
        rod.b = ceiling;
        rod.atB = {4.2, 2.75};
    });
    ObjectId const gearA = moving({circlePiece(0.5)}, {1.6, -1.4}, M::gold);
    ObjectId const gearB = moving({circlePiece(0.25)}, {2.36, -1.4}, M::gold);
    ObjectId const pinA = joint(JointForm::hinge, gearA, {1.6, -1.4}, [](Joint& pin) {
        pin.motor = true;
        pin.motorSpeed = 2;
        pin.motorStrength = 100;
    });
    ObjectId const pinB = joint(JointForm::hinge, gearB, {2.36, -1.4}, plain);
    joint(JointForm::gear, gearA, {}, [&](Joint& gear) {
        gear.b = gearB;
        gear.ratio = 0.5;
        gear.jointA = pinA;
        gear.jointB = pinB;
    });
    ObjectId const cart = moving({boxPiece(1.1, 0.2)}, {4.2, -2.1}, M::wood);
    for (double const x : {3.8, 4.6}) {
        ObjectId const wheel = moving({circlePiece(0.2)}, {x, -2.45}, M::rubber);
        joint(JointForm::wheel, wheel, {x, -2.45}, [&](Joint& axle) {
            axle.b = cart;
            axle.axis = {0, 1};
            axle.stiffness = 4000;
            axle.dampingRate = 60;
        });
    }
    ObjectId const welded = moving({boxPiece(0.2, 0.5)}, {4.2, -1.75}, M::steel);
    joint(JointForm::weld, welded, {4.2, -2.0}, [&](Joint& weld) { weld.b = cart; });
    world.start();
    SceneView view;
    for (int frame = 0; frame < 45; ++frame) {
        view.remember(world);
        world.step();
        if (frame == 30) {
            world.feed({.kind = PlayerInput::Kind::grab, .object = slack, .other = {}, .at = {-2.1, -2.4}});
            world.feed({.kind = PlayerInput::Kind::move, .object = {}, .other = {}, .at = {-3.2, -1.6}});
        }
    }
    Camera camera;
    camera.viewport = {1280, 720};
    camera.fit({-5.6, -3.1}, {5.6, 3.1}, 0);
    GoalRegion const goal{{Box{{-5.3, -2.6}, {1.3, 1.5}}, {}}, false};
    keepForPeople(
        picture(
            camera.viewport, palette::paper,
            [&](Canvas& canvas) {
                canvas.paper();
                view.draw(
                    canvas, world,
                    {.selected = bob, .hovered = hung, .overlays = {.contacts = true}, .goals = {&goal, 1}});
                PartLibrary const library = loadParts(everything(), root / "assets" / "parts");
                drawGhost(canvas, library.find("spanner")->prototype(), {{-0.3, -1.2}, 0.3}, true);
                drawGhost(canvas, library.find("spanner")->prototype(), {{-0.3, -1.8}, 0.3}, false);
                drawGhost(canvas, library.find("electromagnet")->prototype(), {{3.4, 0.2}, 0}, true);
                drawGhost(canvas, library.find("lamp")->prototype(), {{4.4, 0.2}, 0}, true);
                drawGhost(canvas, library.find("horseshoe magnet")->prototype(), {{2.2, 0.2}, 0}, true);
            },
            {}, camera),
        "scene-joints");
    EXPECT_GT(length(world.find<Position>(hung)->value - Vec2{-3.3, 0.6}), 0.01); // the world did run
}

void drawLevel(std::filesystem::path const& file) {
    PartLibrary const library = loadParts(everything(), root / "assets" / "parts");
    LevelFile const level = readLevel(everything(), JsonDocument::load(file));
    std::vector<Placement> const placements =
        level.solutions.empty() ? std::vector<Placement>{} : level.solutions.front().placements;
    auto const world = buildWorld(everything(), level, library, placements);
    Camera camera;
    camera.viewport = trembler::test::underSanitizer ? Size{640, 360} : Size{1280, 720};
    Extent const focus = sceneFocus(*world);
    ASSERT_FALSE(focus.empty());
    camera.fit(focus.lower, focus.upper, 20);
    std::vector<Area> const placing = level.placing.value_or(std::vector<Area>{});
    auto const save = [&](std::string const& suffix, SceneOptions const& options) {
        Image const image = picture(
            camera.viewport, palette::paper,
            [&](Canvas& canvas) {
                canvas.paper();
                drawScene(canvas, *world, options);
            },
            {}, camera);
        keepForPeople(image, "scene-" + file.stem().string() + suffix);
    };
    save("-start", {.placing = placing});
    for (int frame = 0; frame < 240; ++frame) {
        world->step();
    }
    save("-ran", {.time = world->time()});
    save("-overlays",
         {.time = world->time(), .overlays = {.electricity = true, .forces = true, .contacts = true}});
    save("-field", {.time = world->time(), .overlays = {.forces = true, .fieldLines = true}});
}

TEST(SceneGallery, EveryLevel) {
    for (auto const& entry : std::filesystem::recursive_directory_iterator(root / "levels")) {
        if (entry.path().extension() == ".json" &&
            entry.path().filename().string().find("schema") == std::string::npos &&
            entry.path().filename() != "chapter.json") {
            SCOPED_TRACE(entry.path().string());
            EXPECT_NO_THROW(drawLevel(entry.path()));
        }
    }
}

} // namespace
} // namespace trembler::render::test
