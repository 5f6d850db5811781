// trembler why: why something happened in a run, or why a goal was not met.
#include "game/app/commands.hpp"
#include "game/app/mods/mods.hpp"
#include "game/app/options/files/file_rules.hpp"
#include "game/app/options/files/inputs.hpp"
#include "game/app/options/files/outputs.hpp"
#include "game/app/options/run/solution_option.hpp"
#include "game/app/options/values/choice_option.hpp"
#include "game/app/options/values/number_options.hpp"
#include "game/app/progress.hpp"
#include "insight/why/words/words.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "puzzle/checks/checked_level.hpp"
#include "puzzle/goals/words/goal_text.hpp"
#include "puzzle/language/catalogue.hpp"
#include "runtime/component/component.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/limits.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace trembler {
namespace {

struct WhyArguments {
    std::string level;
    std::string solution;
    std::string goal;
    std::optional<std::uint64_t> event;
    std::string object;
    std::optional<double> at;
    std::optional<std::uint64_t> frames;
    bool task = false;
    bool everything = false;
    std::string language = "en";
    std::vector<std::string> mods;
    OutputTarget json;
};

void checkQuestion(WhyArguments const& arguments) {
    int const asked =
        (arguments.goal.empty() ? 0 : 1) + (arguments.event ? 1 : 0) + (arguments.object.empty() ? 0 : 1);
    if (asked > 1) {
        throw CLI::ValidationError(arguments.goal.empty() ? "--event" : "--goal",
                                   "expected one of --goal, --event and --object, not several");
    }
    if (arguments.object.empty() == arguments.at.has_value()) {
        throw CLI::ValidationError(arguments.at ? "--at" : "--object", arguments.at
                                                                           ? "expected --object NAME as well"
                                                                           : "expected --at SECONDS as well");
    }
    if (arguments.at && arguments.frames &&
        *arguments.at > static_cast<double>(*arguments.frames) * frameDuration) {
        throw CLI::ValidationError("--at", fmt::format("expected at most {:g} s, the end of --frames {}",
                                                       static_cast<double>(*arguments.frames) * frameDuration,
                                                       *arguments.frames));
    }
}

insight::Question questionFrom(WhyArguments const& arguments) {
    insight::Question question;
    if (!arguments.goal.empty()) {
        question.goal = arguments.goal;
    }
    question.event = arguments.event;
    if (!arguments.object.empty()) {
        question.object = arguments.object;
        question.at = *arguments.at;
    }
    return question;
}

/// The question in words, for the report.
std::string askedIn(WhyArguments const& arguments, insight::Answer const& answer) {
    if (arguments.event) {
        return fmt::format("event {}", *arguments.event);
    }
    if (!arguments.object.empty()) {
        return fmt::format("object {} at {} s", arguments.object, *arguments.at);
    }
    return fmt::format("goal {}", answer.goal);
}

Catalogue catalogueFor(GameData const& data, std::string const& language) {
    return language == "en" ? Catalogue() : Catalogue(data.home / "assets" / "text", language);
}

/// `world` is that of the level at its beginning.
std::string goalText(LevelFile const& level, World const& world, std::string const& id,
                     Catalogue const& catalogue, bool english) {
    GoalJudge const judge(level, world);
    GermanSpeech const german(catalogue);
    std::vector<std::string> const texts =
        goalSentences(level, world, english ? englishSpeech() : static_cast<Speech const&>(german));
    for (std::size_t i = 0; i < judge.status().size() && i < texts.size(); ++i) {
        if (judge.status()[i].id == id) {
            return texts[i];
        }
    }
    return id;
}

int answerWhy(WhyArguments const& arguments) {
    insight::Question const question = questionFrom(arguments);
    auto const data = gameDataFor(arguments.level, arguments.mods);
    ReadyLevel ready = loadPlayable(data->registry, data->parts, arguments.level);
    LevelFile& level = ready.level;
    Catalogue const catalogue = catalogueFor(*data, arguments.language);
    bool const english = arguments.language == "en";
    Solution solution;
    Outputs outputs;
    readsAll(outputs, *data);
    outputs.reads(arguments.level);
    if (!arguments.solution.empty()) {
        if (level.findSolution(arguments.solution) == nullptr) {
            outputs.reads(arguments.solution);
        }
        solution = solutionStated(data->registry, level, arguments.solution);
    }
    OutputFile* const json = outputs.add("--json", arguments.json);
    if (arguments.task && level.task.is_null()) {
        throw std::invalid_argument("--task: the level has no task; expected a demonstration with one");
    }
    if (!arguments.task) {
        level.task = nullptr; // the goals of a demonstration stay as they are
    }
    if (arguments.task || !english) {
        level = asPlayed(std::move(level), english ? "" : arguments.language);
    }

    insight::LevelRuns const runs(*data, level);
    Progress progress;
    insight::AskOptions options;
    options.everything = arguments.everything;
    options.frames = arguments.frames.value_or(insight::LevelRuns::framesFor(solution));
    options.progress = [&](std::size_t done, std::size_t of) {
        progress.say(fmt::format("{} of {} runs", done, of));
        return true;
    };
    insight::Answer const answer = insight::why(runs, solution, question, options);
    progress.clear();
    reportScriptMessages(*data);

    insight::AnswerLanguage const language =
        english ? insight::AnswerLanguage() : insight::AnswerLanguage(catalogue);
    std::string const goal = answer.goal.empty()
                                 ? std::string()
                                 : goalText(level, *ready.built.world, answer.goal, catalogue, english);
    if (json != nullptr) {
        nlohmann::ordered_json const made = toJson(answer, askedIn(arguments, answer), goal, language);
        json->stream() << escapedJson(
                              made.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
                       << "\n";
    }
    outputs.finish();
    if (json == nullptr || !json->isStandardOutput()) {
        for (std::string const& sentence : sentencesOf(answer, goal, language)) {
            outputs.words() << visible(sentence) << "\n";
        }
        outputs.words() << "(" << sourceOf(answer, language) << ")\n";
    }
    return answer.happened ? exitSolved : exitNotSolved;
}

} // namespace

void addWhyCommand(CLI::App& program, Work& work) {
    auto const arguments = std::make_shared<WhyArguments>();
    CLI::App* const command = program.add_subcommand(
        "why",
        "Say why something happened in a run of a level, confirmed by running it again without each "
        "cause; of a goal that was not met, how nearly. Exit status: 0 it happened, 1 the goal was not "
        "met, 2 bad input or output.");
    addLevel(*command, arguments->level, "Level file (required)");
    addSolution(*command, arguments->solution,
                "Name of a solution recorded in the level, or a file with one");
    accepts(command
                ->add_option("--goal", arguments->goal,
                             "Id of a goal (default: the first that was not met, else the last that was)")
                ->type_name("ID"),
            "the id of a goal of the level");
    addNumber(*command, "--event", arguments->event, 1, 1000000000,
              "Number of an event, as `trembler run --trace` lists them");
    accepts(
        command->add_option("--object", arguments->object, "Name of an object: why it is as it is, see --at")
            ->type_name("NAME"),
        "the name of an object of the level");
    addNumber(*command, "--at", arguments->at, 0, 1e6, "Time in seconds, for --object");
    addNumber(*command, "--frames", arguments->frames, 1, limits::frames,
              "Frames to run, 60 are one second (default: the solution's, else 3600)");
    command->add_flag("--task", arguments->task,
                      "Ask about the task of a demonstration, not about its goals");
    command->add_flag("--everything", arguments->everything,
                      "Also name floors and walls, which are otherwise taken for granted");
    addChoice(*command, "--language", arguments->language, {"en", "de"}, "Of the sentences: en or de")
        ->default_str("en");
    addOptionalFile(*command, "--json", arguments->json, file_kinds::json,
                    "Write one JSON object; on the terminal it replaces the words");
    addModFolders(*command, arguments->mods);
    command->footer(outputConvention);
    command->callback([command, arguments, &work] {
        takeBack(*command, "LEVEL", arguments->level, "--json", arguments->json);
        checkQuestion(*arguments);
        work = [arguments] { return answerWhy(*arguments); };
    });
}

} // namespace trembler
