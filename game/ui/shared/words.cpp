#include "game/ui/shared/words.hpp"

#include "runtime/file/visible_text.hpp"
#include "runtime/level/model/tool_count.hpp"
#include "runtime/math/vec2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace trembler::ui::words {

std::string toolboxHint(std::string const& turnLeft, std::string const& turnRight) {
    std::string const drag = std::string(text("Drag a part into the world.")) + " ";
    if (turnLeft.empty() && turnRight.empty()) {
        return drag + text("The wheel turns it.");
    }
    return drag + (turnLeft.empty() || turnRight.empty()
                       ? textWith("Wheel or {} turns it.", turnLeft + turnRight)
                       : textWith("Wheel or {} and {} turn it.", turnLeft, turnRight));
}
std::string connectedBy(std::string const& callers, std::string const& objects) {
    return textWith("by {}: {}", callers, objects);
}
std::string seekPart(std::string const& key) {
    return key.empty() ? std::string(text("Search")) : textWith("Search ({})", key);
}
std::string wiresLeft(int count) {
    return count == unlimitedCount ? std::string(text("Wire")) : textWith("Wire ({} left)", count);
}
std::string conductsNot(std::string const& object) {
    return textWith("No current flows through {}", theObject(object).words);
}
std::string putThisBack(std::string const& a, std::string const& b) {
    return textWith("Take the wire from {} to {} back", shownName(a), shownName(b));
}
std::string timesReal(double speed) {
    if (speed == 0.25) {
        return "¼×";
    }
    return speed == 0.5 ? "½×" : fmt::format("{:g}×", speed);
}
std::string tooSlow(double asked, double reached) {
    return textWith(
        "This computer is too slow for {}: the world goes at {:.2Lg}×. What happens in it stays the same.",
        timesReal(asked), reached);
}
std::string slowFrame(std::uint64_t frame, double seconds, std::string_view component) {
    return textWith("Frame {} took {:.1Lf} s of processor time, most of it in {}.", frame, seconds,
                    translated(std::string(component)));
}
std::string hold(std::string const& key) {
    return textWith("hold {}", key);
}
std::string keyIsTaken(std::string const& key, std::string const& command) {
    return textWith("{} is the key of \"{}\"", key, command);
}
std::string keepsItsKey(std::string const& command) {
    return textWith("\"{}\" keeps its key", command);
}
std::string noSuchCommand(std::string const& id) {
    return textWith("Keys in your profile: there is no command \"{}\".", visible(id));
}
std::string notAKey(std::string const& id, std::string const& text) {
    return textWith("Keys in your profile: \"{}\" has \"{}\", which is no key; the default key applies.",
                    visible(id), visible(text));
}
std::string keysNotTaken(std::string const& id, std::string const& why) {
    return textWith("Keys in your profile: {}, so the default key of \"{}\" applies.", why, visible(id));
}
std::string keysNotRead(std::string const& what) {
    return textWith("Keys in your profile: expected {}.", visible(what));
}

std::string pictureTaken(std::string const& path) {
    return textWith("Picture written to {}", path);
}

std::string modLine(std::string const& name, std::string const& version, std::string const& author,
                    std::string const& licence) {
    return textWith("{} {}, by {}, {}", name, version, author, licence);
}

std::string levelsOfMod(std::string const& title) {
    return title + " (mod)";
}

std::string modFrom(std::string const& folder) {
    return textWith("From {}.", folder);
}

namespace {

/// With a thin space between groups of three digits.
std::string inGroups(std::uint64_t number) {
    std::string const digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) {
            text += "\u2009";
        }
        text += digits[i];
    }
    return text;
}

std::string inBytes(std::size_t bytes) {
    double const kilo = static_cast<double>(bytes) / 1000;
    return kilo < 1000 ? fmt::format("{:.0f} kB", kilo)
                       : fmt::format(numberLocale(), "{:.1Lf} MB", kilo / 1000);
}

} // namespace

std::string ofMost(std::uint64_t count, std::uint64_t most) {
    return textWith("{} of {}", inGroups(count), inGroups(most));
}

std::string bytesOf(std::size_t bytes, std::size_t most) {
    return textWith("{} of {}", inBytes(bytes), inBytes(most));
}

std::string inFrame(std::uint64_t frame, std::string const& text) {
    return textWith("in frame {}: {}", frame, text);
}

std::string worksButAltered(std::string const& why) {
    return std::string(solved) + " " + translated(why);
}

std::string andMore(std::size_t count) {
    return textWith("and {} more", count);
}
std::string sceneNeeds(std::string const& why) {
    return textWith("The scene needs {}.", translated(why));
}

std::string nothingHas(std::string_view property) {
    return textWith("nothing has \"{}\"", translated(std::string(property)));
}
std::string duration(double microseconds) {
    return microseconds < 9.95    ? fmt::format(numberLocale(), "{:.1Lf} µs", microseconds)
           : microseconds < 999.5 ? fmt::format("{:.0f} µs", microseconds)
                                  : fmt::format(numberLocale(), "{:.3Lg} ms", microseconds / 1000);
}
std::string howFarOff(double metres) {
    if (!(metres > 0)) {
        return text("not at all");
    }
    std::locale const& numbers = numberLocale();
    return metres < 1e-4      ? fmt::format(numbers, "< {:.1Lf} mm", 0.1)
           : metres < 9.95e-3 ? fmt::format(numbers, "{:.1Lf} mm", 1000 * metres)
           : metres < 0.995   ? fmt::format(numbers, "{:.2Lg} cm", 100 * metres)
           : metres < 9.95    ? fmt::format(numbers, "{:.1Lf} m", metres)
                              : fmt::format("{:.0f} m", std::min(metres, 1e6));
}
std::string errorTip(double metres, double share, std::string const& of, std::string const& source) {
    std::string const off = metres > 0 ? howFarOff(metres) : std::string(text("nothing"));
    return textWith("{:.2Lg} % {}: a body that nothing holds would be off by {} after a second. {}",
                    100 * share, translated(of), off, translated(source));
}
std::string budgetOf(double milliseconds) {
    return fmt::format(numberLocale(), "{:.2Lf} ms", milliseconds);
}
std::string budgetIs(double microseconds) {
    return textWith("Time budget: {:.2Lf} ms per frame", microseconds / 1000);
}
std::string ofBudget(double microseconds) {
    return textWith("of a budget of {:.2Lf} ms", microseconds / 1000);
}

std::string ofRated(double share) {
    return textWith(" ({:.0f} % of its rating)", 100 * share);
}

std::string idleNow(std::string const& chosen, std::string const& working) {
    return textWith("{} (used: {})", chosen, working);
}

std::string automaticNow(std::string const& level) {
    return fmt::format("{}: {}", automatic, level);
}
std::string hintOf(std::size_t shown, std::size_t total) {
    return total > 1 ? textWith("Hint {} of {}", shown, total) : std::string(text("Hint"));
}
std::string seconds(double time) {
    return fmt::format(numberLocale(), "{:.1Lf} s", time);
}
std::string solvedWith(double time, int parts) {
    return parts == 0   ? textWith("Solved after {}", seconds(time))
           : parts == 1 ? textWith("Solved after {} with 1 part", seconds(time))
                        : textWith("Solved after {} with {} parts", seconds(time), parts);
}
std::string cutThis(std::string const& a, std::string const& b) {
    return textWith("cut {} – {}", shownName(a), shownName(b));
}

std::string direction(double angle) {
    static constexpr std::array arrows{"→", "↗", "↑", "↖", "←", "↙", "↓", "↘"};
    auto const eighth = static_cast<int>(std::lround(angle / (pi / 4)));
    return arrows[static_cast<std::size_t>(((eighth % 8) + 8) % 8)];
}

std::string capital(std::string text) {
    if (!text.empty()) {
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    }
    return text;
}

std::string wrapped(std::string const& text, std::size_t width) {
    std::string lines;
    std::size_t column = 0;
    std::size_t start = 0;
    while (start < text.size()) {
        std::size_t const end = std::min(text.find(' ', start), text.size());
        std::size_t const length = end - start;
        if (column > 0 && column + 1 + length > width) {
            lines += '\n';
            column = 0;
        } else if (column > 0) {
            lines += ' ';
            ++column;
        }
        lines += text.substr(start, length);
        column += length;
        start = end + 1;
    }
    return lines;
}

} // namespace trembler::ui::words
