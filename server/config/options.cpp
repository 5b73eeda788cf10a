#include "config/options.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <numeric>

#include "tuftwave/limits.hpp"

namespace tuftwave::server {
namespace {

constexpr double kLongestHost = 255;  // a host name has at most 253 characters
constexpr double kLongestPath = 4'095;
constexpr double kLongestList = 8'000;
constexpr std::size_t kTypingErrors = 2;

constexpr std::array kOptions{
    Option{"host", "", &Config::host, 1, kLongestHost, "", "", "Address to serve on; 0.0.0.0 or :: for all"},
    Option{"port", "PORT", &Config::port, 0, 65'535, "", "", "Port to serve on; 0 picks a free one"},
    Option{
        "admin-host", "", &Config::admin_host, 1, kLongestHost, "", "",
        "Address of /livez, /readyz and /metrics; never asks for keys, so keep it where only probes and scrapers come"},
    Option{"admin-port", "", &Config::admin_port, 0, 65'535, "", "",
           "Port of /livez, /readyz and /metrics; 0 picks a free one"},
    Option{"workers", "", &Config::workers, 0, 256, "", "threads",
           "Threads that compute, and as many, at most 8, that serve connections; 0 means as many as cores"},
    Option{"queue", "", &Config::queue, 1, 10'000, "", "jobs",
           "Jobs that may wait for a worker before requests are refused"},
    Option{
        "queue-wait", "", &Config::queue_seconds, 0.001, 60, "", "seconds",
        "How long a burst of jobs may be expected to wait before requests are refused, an eighth of it while the queue "
        "does not empty; one for each worker may wait in any case"},
    Option{"connections", "", &Config::connections, 8, 65'535, "", "",
           "Connections open at once; the next one is refused"},
    Option{"body-memory", "", &Config::body_mib, 1, 65'536, "", "MiB",
           "Memory for the bodies of requests before large ones are refused"},
    Option{"answer-memory", "", &Config::answer_mib, 1, 65'536, "", "MiB",
           "Memory for answers that clients have not taken yet before requests are refused; up to half as much is kept "
           "for a second, for the next answers"},
    Option{"deadline", "", &Config::deadline_seconds, 0.1, 600, "", "seconds",
           "How long a request may wait and compute"},
    Option{"drain", "", &Config::drain_seconds, 0, 60, "", "seconds",
           "How long to go on serving, while not ready, after SIGTERM"},
    Option{"key-file", "", &Config::key_file, 0, kLongestPath, "", "",
           "File of the keys that may call, a line NAME SHA256 [RATE] each; new-key makes one"},
    Option{"insecure", "", &Config::insecure, 0, 0, "yes|no", "",
           "yes: serve to others than this machine without asking for keys"},
    Option{"origins", "", &Config::origins, 0, kLongestList, "", "",
           "Pages elsewhere that may call from a browser, as in https://studio.example, with commas between"},
    Option{
        "rate", "", &Config::rate, 0, 1e6, "", "units a second",
        "Share of each key without a rate of its own, or of all together without keys; 0 for any; a unit is 1 ms of a "
        "worker's time"},
    Option{"burst", "", &Config::burst, 1, 1e9, "", "units", "What a key may save up of its rate"},
    Option{"log-level", "", &Config::log_level, 0, 0, "debug|info|warn|error|off", "", "The least that is logged"},
    Option{"log-format", "", &Config::log_format, 0, 0, "auto|json|text", "",
           "auto: text on a terminal, else one JSON object per line"},
};

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

std::vector<std::string_view> split(std::string_view text, const char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t end; (end = text.find(separator)) != std::string_view::npos; text.remove_prefix(end + 1))
        parts.push_back(text.substr(0, end));
    parts.push_back(text);
    return parts;
}

/// The whole text as a number; nothing for what is no number, infinite, or out of range.
template <class Number>
std::optional<Number> number_within(const std::string_view text, const Option& option) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    if (!is_within(static_cast<double>(value), {option.minimum, option.maximum})) return {};
    return value;
}

bool is_allowed_text(const std::string_view text, const Option& option) {
    if (option.choices.empty()) return is_within(static_cast<double>(text.size()), {option.minimum, option.maximum});
    const auto choices = split(option.choices, '|');
    return std::find(choices.begin(), choices.end(), text) != choices.end();
}

/// Levenshtein's distance: letters to put in, leave out or replace.
std::size_t typing_errors(const std::string_view a, const std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::span<const Option> options() { return kOptions; }

const Option* find_option(const std::string_view name) {
    const auto found =
        std::find_if(kOptions.begin(), kOptions.end(), [&](const Option& option) { return option.name == name; });
    return found == kOptions.end() ? nullptr : &*found;
}

std::vector<std::string> environment_names(const Option& option) {
    std::string name = "TUFTWAVE_";
    for (const char c : option.name) name += c == '-' ? '_' : static_cast<char>(std::toupper(c));
    std::vector<std::string> names{name};
    if (!option.also_env.empty()) names.emplace_back(option.also_env);
    return names;
}

std::string allowed(const Option& option) {
    const std::string range = " from " + to_text(option.minimum) + " to " + to_text(option.maximum);
    return std::visit(Overloaded{[&](int Config::*) { return "a whole number" + range; },
                                 [&](double Config::*) { return "a number" + range; },
                                 [&](std::string Config::*) -> std::string {
                                     if (option.choices.empty())
                                         return "a text of " + to_text(option.minimum) + " to " +
                                                to_text(option.maximum) + " characters";
                                     return "one of " + std::string(option.choices);
                                 }},
                      option.field);
}

std::string value_text(const Option& option, const Config& config) {
    return std::visit(Overloaded{[&](int Config::*field) { return std::to_string(config.*field); },
                                 [&](double Config::*field) { return to_text(config.*field); },
                                 [&](std::string Config::*field) { return config.*field; }},
                      option.field);
}

bool set(const Option& option, const std::string_view text, Config& config) {
    return std::visit(Overloaded{[&](std::string Config::*field) {
                                     if (!is_allowed_text(text, option)) return false;
                                     config.*field = text;
                                     return true;
                                 },
                                 [&]<class Number>(Number Config::*field) {
                                     const std::optional<Number> value = number_within<Number>(text, option);
                                     if (value) config.*field = *value;
                                     return value.has_value();
                                 }},
                      option.field);
}

std::optional<std::string> nearest(const std::string_view word, const std::vector<std::string>& candidates) {
    std::optional<std::string> best;
    std::size_t fewest = kTypingErrors + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t errors = typing_errors(word, candidate);
        if (errors >= fewest) continue;
        fewest = errors;
        best = candidate;
    }
    return best;
}

}  // namespace tuftwave::server
