#include "insight/why/words/answer_text.hpp"

#include <nlohmann/json.hpp>

namespace trembler::insight {
namespace answer_text {
namespace {

using nlohmann::json;

json stepJson(ChainStep const& one) {
    Step const& step = one.step;
    return {static_cast<int>(step.kind),
            step.event.value,
            step.frame,
            step.component,
            step.what,
            step.objects,
            step.because,
            step.traced,
            static_cast<int>(one.proof),
            one.at.x,
            one.at.y,
            one.times,
            one.cycle};
}

ChainStep stepFrom(json const& all) {
    ChainStep one;
    one.step.kind = static_cast<StepKind>(all.at(0).get<int>());
    one.step.event.value = all.at(1).get<std::uint64_t>();
    one.step.frame = all.at(2).get<std::uint64_t>();
    one.step.component = all.at(3).get<std::string>();
    one.step.what = all.at(4).get<std::string>();
    one.step.objects = all.at(5).get<std::vector<std::string>>();
    one.step.because = all.at(6).get<std::vector<std::size_t>>();
    one.step.traced = all.at(7).get<bool>();
    one.proof = static_cast<Proof>(all.at(8).get<int>());
    one.at = {all.at(9).get<double>(), all.at(10).get<double>()};
    one.times = all.at(11).get<std::size_t>();
    one.cycle = all.at(12).get<std::size_t>();
    return one;
}

} // namespace
} // namespace answer_text

std::string toText(Answer const& answer) {
    nlohmann::json chain = nlohmann::json::array();
    for (ChainStep const& one : answer.chain) {
        chain.push_back(answer_text::stepJson(one));
    }
    return nlohmann::json{{"happened", answer.happened},
                          {"goal", answer.goal},
                          {"chain", chain},
                          {"dropped", answer.dropped},
                          {"confirmed", answer.confirmed},
                          {"runs", answer.runs},
                          {"complete", answer.complete},
                          {"frames", answer.frames},
                          {"fixed", answer.facts.fixed},
                          {"lamps", answer.facts.lamps},
                          {"placements", answer.facts.placementOf},
                          {"spoken", answer.facts.spoken}}
        .dump();
}

Answer answerFrom(std::string const& text) {
    nlohmann::json const all = nlohmann::json::parse(text);
    Answer answer;
    answer.happened = all.at("happened").get<bool>();
    answer.goal = all.at("goal").get<std::string>();
    for (nlohmann::json const& one : all.at("chain")) {
        answer.chain.push_back(answer_text::stepFrom(one));
    }
    answer.dropped = all.at("dropped").get<std::size_t>();
    answer.confirmed = all.at("confirmed").get<bool>();
    answer.runs = all.at("runs").get<std::size_t>();
    answer.complete = all.at("complete").get<bool>();
    answer.frames = all.at("frames").get<std::uint64_t>();
    answer.facts.fixed = all.at("fixed").get<std::set<std::string>>();
    answer.facts.lamps = all.at("lamps").get<std::set<std::string>>();
    answer.facts.spoken = all.at("spoken").get<std::map<std::string, std::string>>();
    answer.facts.placementOf = all.at("placements").get<std::map<std::string, std::size_t>>();
    return answer;
}

} // namespace trembler::insight
