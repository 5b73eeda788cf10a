#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tuftwave::server {

/// How the program runs. The table in options.cpp gives each field its flag, its range and its text.
struct Config {
    std::string host = "127.0.0.1";
    int port = 8080;  ///< 0 picks a free one
    std::string admin_host = "127.0.0.1";
    int admin_port = 8081;       ///< 0 picks a free one
    int workers = 0;             ///< threads that compute; 0: as many as cores
    int queue = 256;             ///< jobs that may wait for a worker
    double queue_seconds = 0.1;  ///< and how long they may be expected to
    int connections = 1'024;
    int body_mib = 64;     ///< of all bodies that come in
    int answer_mib = 192;  ///< of all answers that have not been taken
    double deadline_seconds = 10;
    double drain_seconds = 0;
    std::string key_file;         ///< "" if nobody needs a key
    std::string insecure = "no";  ///< "yes" to serve without keys to others than this machine
    std::string origins;          ///< of pages elsewhere that may call from a browser, with commas; "" for none
    double rate = 0;              ///< units a second for each key, 0 for any number; a unit is 1 ms of a worker's time
    double burst = 10'000;        ///< units that a key may save up
    std::string log_level = "info";
    std::string log_format = "auto";
};

struct CommandLine {
    enum class Command { kServe, kHelp, kVersion, kPrintConfig, kHealthcheck, kNewKey };
    Command command = Command::kServe;
    Config config;         ///< defaults only for help, version and new-key
    std::string key_name;  ///< for new-key
};

/// Why the program cannot start: one sentence for people.
struct UsageError {
    std::string message;
};

/// Where options come from besides the command line, so that parsing needs no process.
struct Surroundings {
    std::function<std::optional<std::string>(const std::string& name)> environment;
    std::function<std::optional<std::string>(const std::string& path)> read_file;  ///< nothing if it cannot be read
};

/// Reads all options. A flag goes before the environment, that before the file, that before the default. An empty
/// environment variable counts as none. To serve without keys to others than this machine must be asked for.
/// Of a flag that is given twice the later one counts.
/// @param arguments  without the program's name
std::variant<CommandLine, UsageError> parse(const std::vector<std::string>& arguments,
                                            const Surroundings& surroundings);

/// Whether an address is of this machine only: 127.0.0.0/8, ::1 or localhost.
bool is_loopback(const std::string& host);

/// The process's own environment and files.
Surroundings process_surroundings();

/// Every option with its default, range and environment variables.
std::string help();

/// The configuration as JSON that --config takes.
std::string to_json(const Config& config);

}  // namespace tuftwave::server
