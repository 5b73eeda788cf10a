#include "config/config.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "config/options.hpp"

namespace tuftwave::server {
namespace {

using Command = CommandLine::Command;
using Trouble = std::optional<UsageError>;

const std::string kConfigFlag = "--config";
const std::string kConfigVariable = "TUFTWAVE_CONFIG";

struct Flag {
    const Option* option;
    std::string value;
};

/// The command line, read but not yet believed.
struct Arguments {
    Command command = Command::kServe;
    std::vector<Flag> flags;
    std::optional<std::string> config_path;
    std::string key_name;
};

std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    const std::optional<std::string> guess = nearest(word, known);
    return guess ? "; did you mean " + *guess + "?" : "; --help lists what there is";
}

/// @param origin  "the flag --port", "the environment variable PORT"
UsageError refusal(const Option& option, const std::string& origin, const std::string& given) {
    return {"option " + std::string(option.name) + ": " + given + " from " + origin + " is not " + allowed(option)};
}

Trouble apply(const Option& option, const std::string& origin, const std::string& value, Config& config) {
    if (set(option, value, config)) return {};
    return refusal(option, origin, quoted(value));
}

std::vector<std::string> known_flags() {
    std::vector<std::string> names{"--help", "--version", "--print-config", kConfigFlag};
    for (const Option& option : options()) names.push_back("--" + std::string(option.name));
    return names;
}

std::optional<Command> command_of(const std::string& word) {
    if (word == "--help" || word == "-h") return Command::kHelp;
    if (word == "--version") return Command::kVersion;
    if (word == "--print-config") return Command::kPrintConfig;
    if (word == "healthcheck") return Command::kHealthcheck;
    return {};
}

/// Help and version win over everything else, so that they can be asked for whatever stands beside them.
bool is_final(const Command command) { return command == Command::kHelp || command == Command::kVersion; }

Trouble read_new_key(const std::vector<std::string>& words, Arguments& to) {
    if (words.size() != 2) return UsageError{"new-key needs one name, and nothing else"};
    to.command = Command::kNewKey;
    to.key_name = words[1];
    return {};
}

Trouble read_arguments(const std::vector<std::string>& words, Arguments& to) {
    if (!words.empty() && words.front() == "new-key") return read_new_key(words, to);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (const std::optional<Command> command = command_of(word)) {
            to.command = *command;
            if (is_final(*command)) return {};
            continue;
        }
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        const Option* option = name.starts_with("--") ? find_option(name.substr(2)) : nullptr;
        if (!option && name != kConfigFlag)
            return UsageError{"unknown argument " + quoted(name) + did_you_mean(name, known_flags())};
        if (equals == std::string::npos && i + 1 == words.size())
            return UsageError{"the flag " + name + " needs a value"};
        std::string value = equals == std::string::npos ? words[++i] : word.substr(equals + 1);
        if (option) {
            to.flags.push_back({option, std::move(value)});
        } else {
            to.config_path = std::move(value);
        }
    }
    return {};
}

Trouble apply_entry(const std::string& path, const std::string& key, const nlohmann::json& value, Config& config) {
    const Option* option = find_option(key);
    if (!option) {
        std::vector<std::string> names;
        for (const Option& each : options()) names.emplace_back(each.name);
        return UsageError{"unknown key " + quoted(key) + " in the file " + quoted(path) + did_you_mean(key, names)};
    }
    const std::string origin = "the file " + quoted(path);
    const bool wants_text = std::holds_alternative<std::string Config::*>(option->field);
    if (value.is_structured()) return refusal(*option, origin, "a list or an object");
    if (wants_text != value.is_string() || (!wants_text && !value.is_number()))
        return refusal(*option, origin, value.dump());
    return apply(*option, origin, wants_text ? value.get_ref<const std::string&>() : value.dump(), config);
}

Trouble apply_file(const std::string& path, const Surroundings& surroundings, Config& config) {
    const std::optional<std::string> text = surroundings.read_file(path);
    if (!text) return UsageError{"the file " + quoted(path) + " cannot be read"};
    const nlohmann::json json = nlohmann::json::parse(*text, nullptr, false);
    if (!json.is_object()) return UsageError{"the file " + quoted(path) + " is not a JSON object"};
    for (const auto& [key, value] : json.items()) {
        if (Trouble trouble = apply_entry(path, key, value, config)) return trouble;
    }
    return {};
}

Trouble apply_environment(const Surroundings& surroundings, Config& config) {
    for (const Option& option : options()) {
        for (const std::string& name : environment_names(option)) {
            const std::optional<std::string> value = surroundings.environment(name);
            if (!value || value->empty()) continue;
            if (Trouble trouble = apply(option, "the environment variable " + name, *value, config)) return trouble;
            break;
        }
    }
    return {};
}

Trouble apply_flags(const std::vector<Flag>& flags, Config& config) {
    for (const auto& [option, value] : flags) {
        if (Trouble trouble = apply(*option, "the flag --" + std::string(option->name), value, config)) return trouble;
    }
    return {};
}

/// The weakest first, so that the stronger ones write over it.
Trouble apply_all(const Arguments& arguments, const Surroundings& surroundings, Config& config) {
    std::optional<std::string> path = arguments.config_path;
    if (!path) path = surroundings.environment(kConfigVariable);
    if (path && (arguments.config_path || !path->empty())) {
        if (Trouble trouble = apply_file(*path, surroundings, config)) return trouble;
    }
    if (Trouble trouble = apply_environment(surroundings, config)) return trouble;
    return apply_flags(arguments.flags, config);
}

/// A server that strangers reach is never open by oversight.
Trouble check_who_may(const Config& config) {
    if (is_loopback(config.host) || !config.key_file.empty() || config.insecure == "yes") return {};
    return UsageError{"the host " + quoted(config.host) +
                      " can be reached from elsewhere: give the keys that may call with --key-file PATH, or serve "
                      "everybody with --insecure yes"};
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

}  // namespace

std::variant<CommandLine, UsageError> parse(const std::vector<std::string>& arguments,
                                            const Surroundings& surroundings) {
    Arguments read;
    if (Trouble trouble = read_arguments(arguments, read)) return *std::move(trouble);
    CommandLine line{read.command, {}, read.key_name};
    if (is_final(read.command) || read.command == Command::kNewKey) return line;
    if (Trouble trouble = apply_all(read, surroundings, line.config)) return *std::move(trouble);
    if (read.command == Command::kServe) {
        if (Trouble trouble = check_who_may(line.config)) return *std::move(trouble);
    }
    return line;
}

bool is_loopback(const std::string& host) {
    in_addr v4{};
    if (::inet_pton(AF_INET, host.c_str(), &v4) == 1) return ntohl(v4.s_addr) >> 24 == 127;
    return host == "localhost" || host == "::1";
}

Surroundings process_surroundings() {
    return {[](const std::string& name) -> std::optional<std::string> {
                const char* value = std::getenv(name.c_str());
                return value ? std::optional<std::string>(value) : std::nullopt;
            },
            [](const std::string& path) -> std::optional<std::string> {
                std::ifstream file(path, std::ios::binary);
                if (!file) return {};
                std::string text(std::istreambuf_iterator<char>(file), {});
                return file.bad() ? std::nullopt : std::optional(std::move(text));
            }};
}

std::string help() {
    std::string text =
        "Turns strokes into anime hair, over HTTP.\n\n"
        "Usage: tuftwave-server [OPTIONS]              serve until SIGTERM\n"
        "       tuftwave-server healthcheck [OPTIONS]  ask a running server whether it lives: exit code 0 or 1\n"
        "       tuftwave-server new-key NAME           make a key: the line for --key-file on standard output, the key "
        "itself\n"
        "                                              on standard error\n"
        "       tuftwave-server --print-config [OPTIONS]\n"
        "       tuftwave-server --help | --version\n\n"
        "A flag goes before the environment, that before the file, that before the default.\n\nOptions:\n";
    for (const Option& option : options()) {
        const std::string unit = option.unit.empty() ? "" : ", in " + std::string(option.unit);
        const std::string standard = value_text(option, Config{});
        text += "  --" + std::string(option.name) + " VALUE\n      " + std::string(option.help) + ".\n      Default " +
                (standard.empty() ? "none" : standard) + "; " + allowed(option) + unit + "; environment " +
                joined(environment_names(option), ", then ") + ".\n";
    }
    return text + "  " + kConfigFlag +
           " FILE\n      A JSON object whose keys are the names above; --print-config writes one.\n      Default none; "
           "environment " +
           kConfigVariable + ".\n";
}

std::string to_json(const Config& config) {
    nlohmann::ordered_json json;
    for (const Option& option : options())
        std::visit([&](const auto field) { json[std::string(option.name)] = config.*field; }, option.field);
    return json.dump(2, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace tuftwave::server
