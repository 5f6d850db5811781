#include "measure/accuracy/ladders/ngspice.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <unistd.h>

namespace trembler::accuracy {
namespace {

namespace fs = std::filesystem;

// A file that is deleted with its owner.
class TemporaryFile {
public:
    explicit TemporaryFile(std::string const& text) {
        std::error_code error;
        fs::path const folder = fs::temp_directory_path(error);
        path_ = ((error ? fs::path("/tmp") : folder) / "trembler-XXXXXX").string();
        int const file = mkstemp(path_.data());
        if (file >= 0) {
            good_ = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
            close(file);
        }
    }
    ~TemporaryFile() {
        std::error_code error;
        fs::remove(path_, error);
    }
    TemporaryFile(TemporaryFile const&) = delete;
    TemporaryFile& operator=(TemporaryFile const&) = delete;
    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] std::string const& path() const { return path_; }

private:
    std::string path_;
    bool good_ = false;
};

// Parses lines such as "n3 = 1.25e+00" into values by name.
std::map<std::string, double> valuesIn(std::string const& output) {
    std::map<std::string, double> values;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        std::size_t const sign = line.find(" = ");
        if (sign != std::string::npos && line.find(' ') == sign) {
            values[line.substr(0, sign)] = std::strtod(line.c_str() + sign + 3, nullptr);
        }
    }
    return values;
}

} // namespace

std::optional<std::map<std::string, double>> potentialsByNgspice(std::string const& netlist) {
    TemporaryFile const file(netlist);
    if (netlist.empty() || !file.good()) {
        return std::nullopt;
    }
    std::string output;
    FILE* const pipe = popen(("ngspice -b '" + file.path() + "' 2>/dev/null").c_str(), "r");
    if (pipe == nullptr) {
        return std::nullopt;
    }
    std::array<char, 4096> buffer{};
    while (std::size_t const got = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        output.append(buffer.data(), got);
    }
    pclose(pipe);
    std::map<std::string, double> const values = valuesIn(output);
    if (values.empty()) {
        return std::nullopt;
    }
    // Comment lines "* n3 = 'one', 'another'" list the objects at a node's potential. Node 0 is the return.
    std::map<std::string, double> potentials;
    std::istringstream lines(netlist);
    for (std::string line; std::getline(lines, line);) {
        std::size_t const sign = line.find(" = '");
        if (!line.starts_with("* ") || sign == std::string::npos) {
            continue;
        }
        auto const value = values.find(line.substr(2, sign - 2));
        double const volts = value == values.end() ? 0 : value->second;
        for (std::size_t open = sign + 3; open != std::string::npos && open + 1 < line.size();) {
            std::size_t const close = line.find('\'', open + 1);
            if (close == std::string::npos) {
                break;
            }
            potentials[line.substr(open + 1, close - open - 1)] = volts;
            open = line.find('\'', close + 1);
        }
    }
    return potentials;
}

} // namespace trembler::accuracy
