// Ladders as tables: for people, for programs, for the documentation.
#pragma once

#include "measure/accuracy/ladder.hpp"

#include <nlohmann/json_fwd.hpp>

namespace trembler::accuracy {

/// For a terminal.
[[nodiscard]] std::string asText(std::vector<Ladder> const& ladders);
/// {"ladders": [{"effect", "scene", "unit", "error", "reference", "rivals", "remark", "levels": [{"level",
/// "us_per_frame", "error", "front", "beaten_by", "cannot_tell"}]}]}. An error without bound is null.
[[nodiscard]] nlohmann::ordered_json asJson(std::vector<Ladder> const& ladders);
/// docs/measurements/accuracy.md as a whole; `pictures` is the folder of the plots as seen from there, "" for
/// none.
[[nodiscard]] std::string asMarkdown(std::vector<Ladder> const& ladders, std::string const& pictures);

/// A file name for the ladder, without an ending: "accuracy-gravity-a-disc-of-stars". Numbers that depend on
/// the scene's size stay in; anything but letters and digits becomes a hyphen.
[[nodiscard]] std::string slugOf(Ladder const& ladder);

/// "1.2e-05", "0.031"; "0" of nothing at all, "no bound" of what is not finite.
[[nodiscard]] std::string errorText(double error);
/// Three digits.
[[nodiscard]] std::string timeText(double microseconds);

} // namespace trembler::accuracy
