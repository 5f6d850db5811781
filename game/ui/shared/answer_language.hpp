// The clauses of answers to "why?" in the language in use.
#pragma once

#include "game/ui/shared/catalogue_in_use.hpp"
#include "insight/why/words/clauses.hpp"

namespace trembler::ui {

/// Valid until useLanguage(). Window thread only.
[[nodiscard]] inline insight::AnswerLanguage answerLanguageInUse() {
    Catalogue const* const catalogue = catalogueInUse();
    return catalogue == nullptr ? insight::AnswerLanguage() : insight::AnswerLanguage(*catalogue);
}

} // namespace trembler::ui
