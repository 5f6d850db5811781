#include "insight/why/words/clauses.hpp"

#include "puzzle/language/speech.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace trembler::insight {
namespace {

/// The two forms of what a kind of step says, with a gap for each of its objects.
struct KindText {
    StepKind kind;
    std::string_view main;
    std::string_view because;
};
constexpr std::array<KindText, 15> kindTexts{
    {{StepKind::contact, "{} touches {}", "because {} touches {}"},
     {StepKind::apart, "{} no longer touches {}", "because {} no longer touches {}"},
     {StepKind::on, "current flows through {}", "because current flows through {}"},
     {StepKind::off, "no current flows through {} any more", "because no current flows through {} any more"},
     {StepKind::magnetOn, "{} becomes magnetic", "because {} becomes magnetic"},
     {StepKind::magnetOff, "{} ceases to be magnetic", "because {} ceases to be magnetic"},
     {StepKind::pull, "{} pulls {}", "because {} pulls {}"},
     {StepKind::push, "{} pushes {} away", "because {} pushes {} away"},
     {StepKind::liquid, "{} dips into {}", "because {} dips into {}"},
     {StepKind::grabbed, "you took hold of {}", "because you took hold of {}"},
     {StepKind::released, "you let go of {}", "because you let go of {}"},
     {StepKind::cut, "you cut the wire between {} and {}", "because you cut the wire between {} and {}"},
     {StepKind::removed, "you removed {}", "because you removed {}"},
     {StepKind::wired, "you connected {} and {}", "because you connected {} and {}"},
     {StepKind::placed, "you laid {} there before the start", "because you laid {} there before the start"}}};

/// The same of events that only some effects record; the gaps are the first objects.
struct EventText {
    std::string_view event;
    std::string_view main;
    std::string_view because;
};
constexpr std::array<EventText, 8> eventTexts{
    {{"leaves the liquid", "{} comes out of {}", "because {} comes out of {}"},
     {"enters the air", "{} is in the air", "because {} is in the air"},
     {"leaves the air", "{} is no longer in the air", "because {} is no longer in the air"},
     {"blown", "{} blows", "because {} blows"},
     {"created", "{} comes into being", "because {} comes into being"},
     {"destroyed", "{} is gone", "because {} is gone"},
     {"turns fast enough", "{} turns fast enough", "because {} turns fast enough"},
     {"turns too slowly", "{} turns too slowly", "because {} turns too slowly"}}};

/// The part that an object is a piece of, if it was placed: "wire 1" of "wire 1 left end".
std::string wholeOf(std::string const& piece, SceneFacts const& facts) {
    auto const own = facts.placementOf.find(piece);
    std::string whole = piece;
    for (auto const& [name, placement] : facts.placementOf) {
        if (own == facts.placementOf.end() || placement != own->second || name == piece) {
            continue;
        }
        std::size_t same = 0;
        while (same < whole.size() && same < name.size() && whole[same] == name[same]) {
            ++same;
        }
        bool const atWords =
            (same == whole.size() || whole[same] == ' ') && (same == name.size() || name[same] == ' ');
        whole.resize(atWords                                       ? same
                     : whole.rfind(' ', same) == std::string::npos ? 0
                                                                   : whole.rfind(' ', same));
    }
    return whole.empty() ? piece : whole;
}

} // namespace

std::string const& AnswerLanguage::called(std::string const& name) const {
    if (spoken_ == nullptr) {
        return name;
    }
    auto const at = spoken_->find(name);
    return at == spoken_->end() ? name : at->second;
}

std::string AnswerLanguage::the(std::string const& name) const {
    return catalogue_ == nullptr ? englishSpeech().the(called(name)).words
                                 : catalogue_->names().definite(called(name), GermanCase::nominative);
}

std::string AnswerLanguage::mix(std::string_view english, std::vector<Said> const& said) const {
    char const* const translation = catalogue_ == nullptr ? nullptr : catalogue_->find(english);
    Catalogue::Pieces const pieces =
        Catalogue::piecesOf(translation == nullptr ? english : std::string_view(translation));
    std::string text = pieces.between.front();
    for (std::size_t i = 0; i < pieces.gaps.size(); ++i) {
        Said const one = i < said.size() ? said[i] : Said{};
        bool const accusative = pieces.gaps[i] == "akk";
        if (!one.isName) {
            text += one.text;
        } else if (catalogue_ != nullptr && (accusative || pieces.gaps[i] == "dat")) {
            text += catalogue_->names().definite(called(one.text),
                                                 accusative ? GermanCase::accusative : GermanCase::dative);
        } else {
            text += the(one.text);
        }
        text += pieces.between[i + 1];
    }
    return text;
}

std::string AnswerLanguage::say(std::string_view english, std::vector<std::string> const& names) const {
    std::vector<Said> said;
    for (std::string const& name : names) {
        said.push_back({name, true});
    }
    return mix(english, said);
}

std::string AnswerLanguage::fill(std::string_view english, std::vector<std::string> const& words) const {
    std::vector<Said> said;
    for (std::string const& word : words) {
        said.push_back({word, false});
    }
    return mix(english, said);
}

std::string AnswerLanguage::number(double value, int digits) const {
    std::string text = fmt::format("{:.{}f}", value, digits);
    if (catalogue_ != nullptr) {
        std::replace(text.begin(), text.end(), '.', ',');
    }
    return text;
}

std::string AnswerLanguage::distance(double metres) const {
    if (metres < 0.0095) {
        return number(metres * 1000, metres < 0.00095 ? 1 : 0) + " mm";
    }
    return metres < 0.995 ? number(metres * 100, 0) + " cm" : number(metres, 2) + " m";
}

std::string AnswerLanguage::afterColon(std::string sentence) const {
    return catalogue_ == nullptr ? sentence : capitalised(std::move(sentence));
}

std::string capitalised(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    }
    return text;
}

Clauses clausesOf(Step const& step, SceneFacts const& facts, std::string const& goal,
                  AnswerLanguage const& inUse) {
    AnswerLanguage const language = inUse.calling(facts.spoken);
    if (step.kind == StepKind::goal) {
        return {language.fill("the goal “{}” is met", {goal}),
                language.fill("because the goal “{}” is met", {goal})};
    }
    bool const lamp = !step.objects.empty() && facts.lamps.contains(step.objects.front());
    if (step.kind == StepKind::on && lamp) {
        return {language.say("{} is lit", step.objects), language.say("because {} is lit", step.objects)};
    }
    if (step.kind == StepKind::off && lamp) {
        return {language.say("{} goes out", step.objects), language.say("because {} goes out", step.objects)};
    }
    std::vector<std::string> objects = step.objects;
    if (step.kind == StepKind::placed && !objects.empty()) {
        objects.front() = wholeOf(objects.front(), facts);
    }
    if (isPull(step.kind) && objects.size() == 2) {
        std::swap(objects[0], objects[1]); // the magnet acts
    } else if (objects.size() == 2 && facts.fixed.contains(objects[0]) && !facts.fixed.contains(objects[1])) {
        std::swap(objects[0], objects[1]); // the moving object touches the resting one
    }
    auto const at = std::find_if(kindTexts.begin(), kindTexts.end(),
                                 [&](KindText const& text) { return text.kind == step.kind; });
    if (at != kindTexts.end()) {
        return {language.say(at->main, objects), language.say(at->because, objects)};
    }
    // Names the bodies, as a joint need not have a name.
    if (step.what == "joint overloaded" && step.objects.size() > 1) {
        std::vector<std::string> const bodies(step.objects.begin() + 1, step.objects.end());
        if (bodies.size() == 1) {
            return {language.say("the joint of {} is overloaded", bodies),
                    language.say("because the joint of {} is overloaded", bodies)};
        }
        return {language.say("the joint of {} and {} is overloaded", bodies),
                language.say("because the joint of {} and {} is overloaded", bodies)};
    }
    auto const known = std::find_if(eventTexts.begin(), eventTexts.end(),
                                    [&](EventText const& text) { return text.event == step.what; });
    if (known != eventTexts.end() && !step.objects.empty()) {
        return {language.say(known->main, step.objects), language.say(known->because, step.objects)};
    }
    // An event that a script records has its own words.
    std::string const whose = objects.empty() ? std::string() : language.the(objects.front()) + ": ";
    std::string const text = whose + language.fill(step.what, {});
    return {text, language.fill("because of this: {}", {text})};
}

} // namespace trembler::insight
