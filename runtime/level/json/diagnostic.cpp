#include "runtime/level/json/diagnostic.hpp"

#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace trembler {
namespace {

std::string joined(std::vector<Diagnostic> const& diagnostics) {
    std::string all;
    for (Diagnostic const& diagnostic : diagnostics) {
        if (!all.empty()) {
            all += '\n';
        }
        all += diagnostic.print();
    }
    return all;
}

/// Shortens a text for a message: a key or a text may be as long as its file.
std::string shortened(std::string const& text) {
    constexpr std::size_t longest = 2000; // bytes
    if (text.size() <= longest) {
        return text;
    }
    std::size_t cut = longest;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) {
        --cut; // do not cut inside a character
    }
    return text.substr(0, cut) + "...";
}

} // namespace

std::string Diagnostic::print() const {
    std::string text = file;
    if (line > 0) {
        text += fmt::format(":{}:{}", line, column);
    }
    if (!path.empty()) {
        text += fmt::format(": {}", shortened(path));
    }
    text += fmt::format(": {}", shortened(message));
    if (!expected.empty()) {
        text += fmt::format("; expected {}", shortened(expected));
    }
    return visible(text); // any of it may come from the file
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), diagnostics_(std::move(diagnostics)) {}

void Problems::add(Diagnostic diagnostic) {
    ++count_;
    if (hasRoom()) {
        kept_.push_back(std::move(diagnostic));
    }
}

void Problems::throwIfAny() const {
    if (empty()) {
        return;
    }
    std::vector<Diagnostic> sorted = kept_;
    std::stable_sort(sorted.begin(), sorted.end(), [](Diagnostic const& a, Diagnostic const& b) {
        return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
    });
    if (count_ > kept_.size()) {
        Diagnostic rest;
        rest.file = sorted.back().file;
        rest.message = fmt::format("and {} more", count_ - kept_.size());
        sorted.push_back(std::move(rest));
    }
    throw InputError(std::move(sorted));
}

} // namespace trembler
