#include "game/ui/shared/recorder.hpp"

#include "game/ui/shared/words.hpp"
#include "render/gl/error.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

#include <system_error>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

/// The first of name-1, name-2 ... that does not exist.
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
    try {
        writeFile(path, escapedJson(writeSolution(solution).dump(2)) + "\n");
    } catch (OutputError const& error) {
        throw render::RenderError(error.what());
    }
    return path;
}

} // namespace trembler::ui
