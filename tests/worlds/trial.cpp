#include "tests/worlds/trial.hpp"

#include "physics/dynamics/properties/engine_state.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/property/idle_visitor.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/levels/schema_validator.hpp"
#include "tests/worlds/random_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>

namespace trembler::worlds {
namespace {

using Json = nlohmann::json;

double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Finds the first number of a property that is not finite.
class FiniteCheck final : public IdleVisitor {
public:
    std::string wrong;

    void number(FieldInfo const& info, double& value) override {
        if (!std::isfinite(value) && wrong.empty()) {
            wrong = fmt::format("{} is {}", info.key, value);
        }
    }
    void vector(FieldInfo const& info, Vec2& value) override {
        number(info, value.x);
        number(info, value.y);
    }
    void list(FieldInfo const&, ListField& field) override {
        for (std::size_t i = 0; i < field.size(); ++i) {
            field.visitElement(i, *this);
        }
    }
};

std::string notFinite(World const& world) {
    for (ColumnBase const* column : world.store().columns()) {
        for (ObjectId const id : column->owners()) {
            FiniteCheck check;
            column->visitCopy(id, check);
            if (!check.wrong.empty()) {
                return fmt::format("frame {}: {} of '{}': {}", world.frame(), column->info().text.key,
                                   world.store().nameOf(id), check.wrong);
            }
        }
    }
    for (SlotBase const* slot : world.store().slots()) { // resolver and derived properties
        FiniteCheck check;
        slot->visitCopy(check);
        if (!check.wrong.empty()) {
            return fmt::format("frame {}: {}: {}", world.frame(), slot->info().text.key, check.wrong);
        }
    }
    return {};
}

/// Removes refused values until the level is accepted; returns the remaining level, and the last refusal.
std::string makeAcceptable(Json level, Json const& schema) {
    constexpr int most = 400; // a refusal may name but one of many wrong values
    for (int round = 0; round < most; ++round) {
        try {
            LevelFile const file =
                readLevel(levelKit().registry, JsonDocument::parse(level.dump(1), "random.json"));
            Session session(levelKit().registry, levelKit().parts, file);
            for (Solution const& solution : file.solutions) {
                session.load(solution);
            }
            std::string fault;
            if (auto const problems = validate(schema, level); !problems.empty()) {
                fault = "the reader accepts what the schema refuses: " + problems.front();
            }
            return Json{{"level", level}, {"fault", fault}}.dump();
        } catch (InputError const& error) {
            std::vector<std::string> paths;
            for (Diagnostic const& diagnostic : error.diagnostics()) {
                if (diagnostic.line == 0 && !diagnostic.message.starts_with("and ")) {
                    return Json{{"level", level}, {"fault", "refused without a place: " + diagnostic.print()}}
                        .dump();
                }
                if (diagnostic.file == "random.json") { // and not a part's file
                    paths.push_back(diagnostic.path);
                }
            }
            std::sort(paths.begin(), paths.end(), [](std::string const& a, std::string const& b) {
                return a.size() != b.size() ? a.size() > b.size() : a > b; // later entries of a list first
            });
            paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
            bool less = false;
            for (std::string const& path : paths) {
                less = takeAway(level, path) || less;
            }
            for (Json& object : level["objects"]) { // the error is in a part
                less = less || object.erase("part") > 0;
            }
            if (!less) {
                return Json{{"level", level}, {"fault", "cannot be mended: " + std::string(error.what())}}
                    .dump();
            }
        }
    }
    return Json{{"level", level}, {"fault", "is refused again and again"}}.dump();
}

/// Runs the level on one engine. Returns the failure, if any, and the time of the slowest frame without a
/// message.
std::string runOn(std::string const& detail, Json const& level, TrialOptions const& options) {
    LevelFile const file = readLevel(levelKit().registry, JsonDocument::parse(level.dump(1), "random.json"));
    std::uint64_t first = 0;
    double slowest = 0;
    for (int const threads : options.threads) {
        WorldOptions how;
        how.threads = threads;
        how.rowsWorthThreads = 0;
        how.detail = file.detail;
        how.detail["dynamics"] = detail;
        Session session(levelKit().registry, levelKit().parts, file, how);
        if (!file.solutions.empty()) {
            session.load(file.solutions.front());
        }
        World const& world = std::as_const(session).world();
        for (int frame = 0; frame < options.frames; ++frame) {
            double const before = processorTime();
            session.step();
            if (threads == options.threads.front()) {
                auto const* const engine = world.find<EngineState>();
                bool const failed = engine != nullptr && engine->troubled(); // the engine reported a failure
                slowest = failed ? slowest : std::max(slowest, processorTime() - before);
                if (std::string wrong = notFinite(world); !wrong.empty()) {
                    return Json{{"fault", wrong}, {"slowest", slowest}}.dump();
                }
            }
        }
        std::uint64_t const hash = world.stateHash();
        if (threads == options.threads.front()) {
            first = hash;
        } else if (hash != first) {
            return Json{{"fault", fmt::format("the hash on {} threads differs from that on {}", threads,
                                              options.threads.front())},
                        {"slowest", slowest}}
                .dump();
        }
    }
    return Json{{"fault", ""}, {"slowest", slowest}}.dump();
}

/// Why a child process returned no result; nothing if it did.
std::string brokenOff(Ended const& ended) {
    if (ended.signal == SIGXCPU || ended.signal == SIGKILL) {
        return "hangs: it took too much processor time or memory";
    }
    if (ended.signal != 0) {
        return fmt::format("signal {} ({})", ended.signal, strsignal(ended.signal));
    }
    return ended.status != 0 ? fmt::format("ends with status {}", ended.status) : std::string();
}

} // namespace

Outcome tryOut(Json level, Json const& schema, TrialOptions const& options) {
    Outcome outcome;
    (void)levelKit(); // loaded once, not in every child
    Ended const read = inChild([&] { return makeAcceptable(level, schema); }, options.seconds);
    outcome.level = level;
    if (std::string const broken = brokenOff(read); !broken.empty()) {
        outcome.failures.push_back({"reading", broken, read.murmured});
        return outcome;
    }
    Json const accepted = Json::parse(read.said);
    outcome.level = accepted.at("level");
    if (std::string const fault = accepted.at("fault"); !fault.empty()) {
        outcome.failures.push_back({"reading", fault, read.murmured});
        return outcome;
    }
    outcome.played = true;
    double const allSlow =
        options.frameSeconds * options.frames * static_cast<double>(options.threads.size());
    auto const limit = static_cast<unsigned>(std::max(static_cast<double>(options.seconds), allSlow));
    for (std::string const& engine : options.engines) {
        Ended const ran = inChild([&] { return runOn(engine, outcome.level, options); }, limit);
        std::string fault = brokenOff(ran);
        double slowest = 0;
        if (fault.empty()) {
            Json const said = Json::parse(ran.said);
            fault = said.at("fault");
            slowest = said.at("slowest");
        }
        if (fault.empty() && slowest > options.frameSeconds) {
            fault =
                fmt::format("a frame took {:.2f} s of processor time, and no message said so; expected at "
                            "most {:.2f} s",
                            slowest, options.frameSeconds);
        }
        if (!fault.empty()) {
            outcome.failures.push_back({engine, fault, ran.murmured});
        }
    }
    return outcome;
}

std::string inWords(Failure const& failure) {
    std::string text = fmt::format("{}: {}", failure.engine, failure.what);
    if (!failure.murmured.empty()) {
        text += fmt::format("; it said: {}", failure.murmured.substr(0, 400));
    }
    return text;
}

} // namespace trembler::worlds
