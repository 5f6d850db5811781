// trembler: the program.
#include "game/app/program.hpp"
#include "game/app/standard_streams.hpp"

#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
    trembler::StandardStreams streams;
    trembler::Request const request = trembler::requestFrom(std::vector<std::string>(argv + 1, argv + argc));
    std::cout << request.out;
    std::cerr << request.err;
    return streams.finish(request.work ? trembler::guarded(request.work) : request.status);
}
