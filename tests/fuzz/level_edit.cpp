#include "puzzle/edit/problems/live_problems.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/puzzle/edit/any_command.hpp"
#include "tests/support/game_data.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

namespace trembler::edit {
namespace {

constexpr int mostCommands = 40;

std::optional<LevelDocument> documentOf(std::string_view text) {
    try {
        return LevelDocument::fromText(gameData(), std::string(text), {}, {});
    } catch (InputError const&) { // not JSON
        return std::nullopt;
    }
}

void mustHold(bool condition, char const* what) {
    if (!condition) {
        throw std::logic_error(what);
    }
}

} // namespace

void fuzzLevelEdit(std::string_view bytes) {
    std::size_t const end = std::min(bytes.find('\0'), bytes.size());
    auto document = documentOf(bytes.substr(0, end));
    if (!document || (document->readOnly() && !document->mayBeEdited())) {
        return;
    }
    if (document->readOnly()) {
        document->editNevertheless();
    }
    std::string const before = document->text();
    std::string_view rest = bytes.substr(std::min(end + 1, bytes.size()));
    auto const next = [&](int below) {
        if (rest.empty() || below <= 0) {
            return 0;
        }
        int const byte = static_cast<unsigned char>(rest.front());
        rest.remove_prefix(1);
        return byte % below;
    };
    for (int i = 0; i < mostCommands && !rest.empty(); ++i) {
        try {
            document->run(anyCommand(*document, next));
        } catch (CommandError const&) { // reported to the author
            continue;
        }
    }
    LiveProblems problems;
    static_cast<void>(problems.refresh(*document));
    std::string const after = document->text();
    std::size_t const steps = document->done();
    document->goTo(0);
    mustHold(document->text() == before, "undoing everything does not give the file");
    document->goTo(steps);
    mustHold(document->text() == after, "redoing everything does not give the file again");
    mustHold(documentOf(after).has_value(), "the file cannot be read again");
}

} // namespace trembler::edit
