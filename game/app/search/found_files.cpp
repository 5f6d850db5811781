#include "game/app/search/found_files.hpp"

#include "insight/search/recorded.hpp"
#include "runtime/file/folders.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/level/write/write_level.hpp"

#ifndef TREMBLER_HEADLESS
#include "game/app/options/run/solution_option.hpp"
#include "game/ui/headless/screenshot.hpp"
#include "render/gl/png.hpp"
#endif

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace trembler {
namespace {

namespace fs = std::filesystem;

#ifndef TREMBLER_HEADLESS
void drawFound(GameData const& data, fs::path const& level, insight::FoundSolution const& found,
               KeptFiles const& files) {
    ui::ScreenshotOptions options;
    options.frame = found.needs.leastFrame;
    options.size = {960, 540};
    auto const session = sessionStated(data, level, files.solution.string());
    OutputFile file(files.picture, OutputFile::Content::binary);
    render::writePng(ui::screenshot(*session, options), file);
    file.commit();
}
#endif

/// Both names with the first stem of which they are free, and the reason for another one than the first.
KeptFiles namesFor(std::string const& stem, fs::path const& folder, Outputs const& outputs) {
    KeptFiles files;
    for (int copy = 1;; ++copy) {
        std::string const name = copy == 1 ? stem : fmt::format("{}-{}", stem, copy);
        files.solution = folder / (name + ".json");
        files.picture = folder / (name + ".png");
        bool const solutionIsFree = outputs.isFree(files.solution);
        if (solutionIsFree && outputs.isFree(files.picture)) {
            return files;
        }
        if (copy == 1) {
            files.otherName = fmt::format("{} is in use and was not replaced",
                                          (solutionIsFree ? files.picture : files.solution).string());
        }
    }
}

} // namespace

KeptFiles keepFound(GameData const& data, fs::path const& level, insight::FoundSolution const& found,
                    std::size_t number, fs::path const& folder, Outputs const& outputs) {
    makeFolder(folder);
    KeptFiles files = namesFor(fmt::format("{}-found-{}", level.stem().string(), number), folder, outputs);
    writeFile(files.solution, writeSolution(insight::keptSolution(found, number)).dump(2) + "\n");
#ifdef TREMBLER_HEADLESS
    files.picture.clear();
    files.whyNoPicture = "this build was made without drawing";
    (void)data;
#else
    try {
        drawFound(data, level, found, files);
    } catch (std::exception const& problem) { // no OpenGL on this machine: the solution counts
        files.picture.clear();
        files.whyNoPicture = problem.what();
    }
#endif
    return files;
}

} // namespace trembler
