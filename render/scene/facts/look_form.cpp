#include "render/scene/facts/look_form.hpp"

#include <string_view>

namespace trembler::render {
namespace {

bool hasBody(Facts const& facts) {
    return facts.shape != nullptr && !facts.shape->pieces.empty();
}

LookForm ownForm(Facts const& facts) {
    if (facts.source && facts.earth) {
        return LookForm::battery;
    }
    if (facts.device && facts.substance == Substance::glass && hasBody(facts)) {
        return LookForm::bulb;
    }
    std::optional<Sign> const sign = facts.coil == nullptr ? signOf(facts) : std::nullopt;
    if (!sign) {
        return LookForm::plain;
    }
    switch (*sign) {
    case Sign::plus:
        return LookForm::plus;
    case Sign::minus:
        return LookForm::minus;
    case Sign::earth:
        return LookForm::earth;
    case Sign::flash:
    case Sign::north: // these two are no signs of electricity
    case Sign::south:
        break;
    }
    return LookForm::flash;
}

} // namespace

LookForm formOf(Facts const& facts) {
    if (facts.form == LookForm::own && facts.drawing != nullptr && !facts.drawing->marks) {
        return LookForm::plain; // the drawing shows its function
    }
    bool const possible = facts.form != LookForm::bulb || hasBody(facts);
    return facts.form != LookForm::own && possible ? facts.form : ownForm(facts);
}

std::optional<Sign> signOf(Facts const& facts) {
    if (facts.source) {
        return Sign::plus;
    }
    if (facts.earth) {
        if (facts.form == LookForm::minus || facts.form == LookForm::earth) {
            return facts.form == LookForm::minus ? Sign::minus : Sign::earth;
        }
        std::string_view const label = facts.look != nullptr ? facts.look->label : std::string_view{};
        return label == "-" || label == "\u2212" ? Sign::minus : Sign::earth;
    }
    if (facts.device || facts.coil != nullptr) {
        return Sign::flash;
    }
    return std::nullopt;
}

std::optional<Sign> signUnderLabel(Facts const& facts, Sign sign) {
    bool const labelled = facts.look != nullptr && !facts.look->label.empty();
    return labelled && sign == Sign::flash ? std::nullopt : std::optional(sign);
}

bool isShown(DrawnWhen when, Facts const& facts) {
    bool const on = facts.coil != nullptr ? facts.magnetLevel() > 0 : facts.on;
    switch (when) {
    case DrawnWhen::always:
        return true;
    case DrawnWhen::on:
        return on;
    case DrawnWhen::off:
        return !on;
    case DrawnWhen::conducts:
        return facts.conductor;
    case DrawnWhen::insulates:
        return !facts.conductor;
    }
    return true;
}

} // namespace trembler::render
