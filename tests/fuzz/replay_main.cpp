// Runs inputs again without libFuzzer, so that every compiler's build knows what once failed:
// tuftwave_replay NAME FILE... Ends with 0 if all of them pass.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "targets.hpp"

int main(int count, char** arguments) {
    const auto* const target = tuftwave::server::fuzz::find_target(count > 1 ? arguments[1] : "");
    if (target == nullptr) {
        std::fprintf(stderr, "usage: tuftwave_replay NAME FILE...; names are:");
        for (const auto& known : tuftwave::server::fuzz::targets()) std::fprintf(stderr, " %s", known.name.c_str());
        std::fprintf(stderr, "\n");
        return 2;
    }
    for (int i = 2; i < count; ++i) {
        std::ifstream file(arguments[i], std::ios::binary);
        if (!file) {
            std::fprintf(stderr, "tuftwave_replay: cannot read %s\n", arguments[i]);
            return 2;
        }
        const std::string input((std::istreambuf_iterator<char>(file)), {});
        std::fprintf(stderr, "%s\n", arguments[i]);
        target->run(*target, input);
    }
    std::printf("%d inputs pass\n", count - 2);
    return 0;
}
