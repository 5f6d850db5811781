// The editor as a process that is killed in the midst of work: what was done is offered again, and the
// level's file is whole at every moment.
#include "tests/game/app/program.hpp"

#include <SDL_keycode.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class EditorKilled : public InAFolder {
protected:
    void SetUp() override {
        InAFolder::SetUp();
        ASSERT_EQ(::mkfifo(pipe().c_str(), 0600), 0);
        events = ::open(pipe().c_str(), O_RDWR | O_CLOEXEC); // open for reading, too, so that it never ends
        ASSERT_GE(events, 0);
        fs::copy_file(levelFile("first/1-first-contact.json"), file());
    }
    void TearDown() override {
        ::close(events);
        InAFolder::TearDown();
    }

    [[nodiscard]] std::string pipe() const { return at("events"); }
    [[nodiscard]] std::string file() const { return at("level.json"); }
    [[nodiscard]] fs::path recoveries() const { return folder / "data" / "trembler" / "recovery"; }

    void send(std::string const& line) const {
        std::string const all = line + "\n";
        ASSERT_EQ(::write(events, all.data(), all.size()), static_cast<ssize_t>(all.size()));
    }
    void key(SDL_Keycode code, int modifiers = KMOD_NONE) const {
        send("down " + std::to_string(code) + " " + std::to_string(modifiers));
        send("up " + std::to_string(code));
    }
    /// A box in the middle of the view.
    void addBox() const {
        key(SDLK_2);
        key(SDLK_2);
    }

    [[nodiscard]] std::vector<fs::path> recoveryFiles() const {
        std::vector<fs::path> files;
        std::error_code none;
        for (fs::directory_iterator at(recoveries(), none), end; !none && at != end; at.increment(none)) {
            if (at->path().extension() == ".json") {
                files.push_back(at->path());
            }
        }
        return files;
    }
    /// The most objects that a complete recovery file has; 0 if there is none.
    [[nodiscard]] std::size_t recoveredObjects() const {
        std::size_t most = 0;
        std::error_code none;
        for (fs::directory_iterator at(recoveries(), none), end; !none && at != end; at.increment(none)) {
            if (at->path().extension() != ".json") {
                continue;
            }
            Json const stored = Json::parse(contentsOf(at->path()), nullptr, false);
            if (stored.is_object()) { // else it was removed a moment ago
                EXPECT_EQ(stored["level"], file());
                Json const level = Json::parse(stored["text"].get<std::string>(), nullptr, false);
                EXPECT_TRUE(level.is_object());
                most = std::max(most, level["objects"].size());
            }
        }
        return most;
    }

    /// Runs the editor with this level; `work` gets its process id and returns whether it is to be killed
    /// then.
    Ran edit(std::function<bool(int)> const& work) const {
        return runProgram({"edit", file()},
                          {.environment = {{"LD_PRELOAD", TREMBLER_EVENT_FEEDER},
                                           {"TREMBLER_FED_EVENTS", pipe()},
                                           {"SDL_VIDEODRIVER", "offscreen"},
                                           {"SDL_AUDIODRIVER", "dummy"},
                                           {"ASAN_OPTIONS", "verify_asan_link_order=0:detect_leaks=0"},
                                           {"XDG_DATA_HOME", at("data")},
                                           {"XDG_CONFIG_HOME", at("config")},
                                           {"HOME", at("user")}},
                           .meanwhile = [&](int process) {
                               if (work(process)) {
                                   ::kill(process, SIGKILL);
                               }
                           }});
    }
    /// Waits until a recovery file has that many objects.
    [[nodiscard]] std::function<bool(int)> untilRecovered(std::size_t objects) const {
        return [this, objects](int process) {
            EXPECT_TRUE(waitUntil(process, [&] { return recoveredObjects() >= objects; }));
            return true;
        };
    }
    /// On the question whether to recover: the first button. The keys of the first pictures do not act on it.
    void agree() const {
        for (int i = 0; i < 3; ++i) {
            send("up 0");
        }
        key(SDLK_DOWN);
        key(SDLK_RETURN);
    }

    int events = -1;
};

TEST_F(EditorKilled, WorkIsOfferedAgainWheneverItWasKilled) {
    std::string const before = contentsOf(file());
    std::size_t const objects = Json::parse(before)["objects"].size();

    // As soon as unsaved work is on the disk.
    addBox();
    Ran ran = edit(untilRecovered(objects + 1));
    ASSERT_EQ(ran.status, -1) << "it was killed\n" << ran.out << ran.err;
    EXPECT_EQ(contentsOf(file()), before);
    EXPECT_EQ(recoveredObjects(), objects + 1);

    // Recovered, and killed in a test play after one more change.
    agree();
    addBox();
    key(SDLK_SPACE);
    ran = edit(untilRecovered(objects + 2));
    ASSERT_EQ(ran.status, -1) << ran.out << ran.err;
    EXPECT_EQ(contentsOf(file()), before);

    // Recovered, and killed while it writes: then the work before it is there. Not while it takes over the
    // work that was recovered, as then both would be offered.
    std::vector<fs::path> const earlier = recoveryFiles();
    agree();
    addBox();
    ran = edit([&](int process) {
        waitUntil(process, [&] {
            return std::none_of(earlier.begin(), earlier.end(),
                                [](fs::path const& file) { return fs::exists(file); }) &&
                   (writesInto(process, recoveries()) || recoveredObjects() >= objects + 3);
        });
        return true;
    });
    ASSERT_EQ(ran.status, -1) << ran.out << ran.err;
    EXPECT_EQ(contentsOf(file()), before);
    std::size_t const kept = recoveredObjects();
    EXPECT_GE(kept, objects + 2);

    // Recovered, saved and left in order: the file has everything, and nothing is offered any more.
    agree();
    ran = edit([&](int process) {
        auto const saved = [&] { return Json::parse(contentsOf(file()), nullptr, false); };
        // The work that was recovered is kept again by this process before the old file goes.
        key(SDLK_s, KMOD_LCTRL);
        EXPECT_TRUE(
            waitUntil(process, [&] { return saved().is_object() && saved()["objects"].size() == kept; }));
        send("quit");
        return false;
    });
    EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
    EXPECT_EQ(recoveredObjects(), 0U);
}

} // namespace
} // namespace trembler::test
