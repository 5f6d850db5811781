#include "game/ui/recorder.hpp"

#include "game/ui/words.hpp"
#include "render/gl/error.hpp"
#include "runtime/level/write_level.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

/// The first of name-1, name-2 ... that is not there.
fs::path fresh(fs::path const& folder, std::string const& name, char const* ending) {
    std::error_code ignored;
    for (int n = 1;; ++n) {
        fs::path path = folder / fmt::format("{}-{}{}", name, n, ending);
        if (!fs::exists(path, ignored)) {
            return path;
        }
    }
}

} // namespace

void Recorder::start() {
    film_ = fresh(folder_, "film", "");
    std::error_code failed;
    fs::create_directories(film_, failed);
    if (failed) {
        throw render::RenderError(words::cannotWrite(film_.string(), failed.message()));
    }
    frames_ = 0;
    recording_ = true;
}

void Recorder::add(render::Image const& image) {
    try {
        render::writePng(image, film_ / fmt::format("frame-{:05d}.png", frames_ + 1));
        ++frames_;
    } catch (render::RenderError const&) {
        recording_ = false;
        throw;
    }
}

fs::path Recorder::picture(render::Image const& image) {
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    fs::path path = fresh(folder_, "picture", ".png");
    render::writePng(image, path);
    return path;
}

fs::path Recorder::solution(Solution const& solution, std::string const& level) {
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    fs::path path = fresh(folder_, level + "-solution", ".json");
    std::ofstream file(path);
    file << writeSolution(solution).dump(2) << '\n' << std::flush;
    if (!file) {
        throw render::RenderError(words::cannotWrite(path.string(), std::generic_category().message(errno)));
    }
    return path;
}

} // namespace trembler::ui
