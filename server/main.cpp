#include <cstdio>
#include <exception>
#include <string>
#include <variant>
#include <vector>

#include "access/keys.hpp"
#include "access/new_key.hpp"
#include "config/config.hpp"
#include "http/healthcheck.hpp"
#include "http/run.hpp"
#include "version.hpp"

namespace {

using namespace tuftwave::server;

constexpr int kFailed = 1, kWrongUsage = 2;

int print(const std::string& text) { return std::fputs(text.c_str(), stdout) < 0 ? kFailed : 0; }

int healthcheck(const Config& config) {
    const int status = http_status(config.admin_host, config.admin_port, "/livez");  // a full server is healthy
    if (status == 200) return 0;
    std::fprintf(stderr, "tuftwave-server: not alive (%s)\n",
                 status == 0 ? "no answer" : std::to_string(status).c_str());
    return kFailed;
}

/// The line first: a key that its file has not got would only be trouble.
int print_new_key(const std::string& name) {
    if (!is_key_name(name)) {
        std::fprintf(stderr, "tuftwave-server: the name of a key has 1 to 64 of A-Z a-z 0-9 . _ -\n");
        return kWrongUsage;
    }
    const NewKey made = new_key(name);
    if (print(made.line + "\n") != 0 || std::fflush(stdout) != 0) return kFailed;
    std::fprintf(stderr, "The key of %s, shown only now, to be sent as Authorization: Bearer KEY, is\n%s\n",
                 name.c_str(), made.key.c_str());
    return 0;
}

int obey(const CommandLine& line) {
    switch (line.command) {
        case CommandLine::Command::kServe:
            return run(line.config);
        case CommandLine::Command::kHelp:
            return print(help());
        case CommandLine::Command::kVersion:
            return print(std::string("tuftwave-server ") + kVersion + "\n");
        case CommandLine::Command::kPrintConfig:
            return print(to_json(line.config));
        case CommandLine::Command::kHealthcheck:
            return healthcheck(line.config);
        case CommandLine::Command::kNewKey:
            return print_new_key(line.key_name);
    }
    return kFailed;
}

}  // namespace

int main(int count, char** words) {
    try {
        const auto parsed = parse(std::vector<std::string>(words + 1, words + count), process_surroundings());
        if (const auto* error = std::get_if<UsageError>(&parsed)) {
            std::fprintf(stderr, "tuftwave-server: %s\n", error->message.c_str());
            return kWrongUsage;
        }
        return obey(std::get<CommandLine>(parsed));
    } catch (const std::exception& error) {  // no memory, no threads
        std::fprintf(stderr, "tuftwave-server: %s\n", error.what());
        return kFailed;
    }
}
