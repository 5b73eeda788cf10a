#include "access/access.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "api/routes.hpp"

namespace tuftwave::server {
namespace {

constexpr double kUnitsPerSecond = 1'000;  // of a worker
constexpr double kUnitsPerRequest = 1;
constexpr std::uint64_t kBytesPerUnit = 64 * 1024;  // reading a body is work that no worker's clock sees

constexpr const char* kChallenge = "Bearer realm=\"tuftwave\"";
constexpr const char* kInvalidToken = "Bearer realm=\"tuftwave\", error=\"invalid_token\"";

double units_of(const std::uint64_t bytes) { return static_cast<double>(bytes / kBytesPerUnit); }

/// What Content-Length says; 0 where it says nothing sensible, which the framing refuses.
std::uint64_t announced_bytes(const Request& head) {
    const std::string& text = head.header("content-length");
    std::uint64_t bytes = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bytes);
    return error == std::errc{} && end == text.data() + text.size() ? bytes : 0;
}

/// Everything that is not listed here needs a key, so that a path that is added later does.
bool is_open_to_all(const Request& head) {
    if (head.method == "OPTIONS") return true;
    if (head.method != "GET" && head.method != "HEAD") return false;
    const std::string_view path = head.path;
    return path == "/" || path == "/openapi.yaml" || path == "/docs" || path.starts_with("/docs/") ||
           path.starts_with("/studio/");
}

Problem unauthorized(const bool is_given) {
    return {ProblemCode::kUnauthorized, "", {}, {{"WWW-Authenticate", is_given ? kInvalidToken : kChallenge}}};
}

/// @param seconds  until the balance is above zero; the next whole second is surely behind that
Problem over_share(const double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::min(std::floor(seconds), 1e9)) + 1;
    return {ProblemCode::kOverShare, "", {}, {{"Retry-After", std::to_string(whole)}}};
}

}  // namespace

std::variant<std::unique_ptr<Access>, UsageError> Access::open(const Config& config, Now now) {
    auto origins = Origins::parse(config.origins);
    if (const auto* error = std::get_if<std::string>(&origins)) return UsageError{*error};
    std::optional<Keys> keys;
    std::string warning;
    if (!config.key_file.empty()) {
        auto file = read_key_file(config.key_file);
        if (const auto* error = std::get_if<KeyFileError>(&file)) return UsageError{error->message};
        keys = std::get<KeyFile>(file).keys;
        warning = std::get<KeyFile>(file).warning;
    } else if (!is_loopback(config.host)) {
        warning = "serving everybody without keys";
    }
    auto made =
        std::make_unique<Access>(config, std::move(keys), std::get<Origins>(std::move(origins)), std::move(now));
    made->warning_ = std::move(warning);
    return made;
}

Access::Access(const Config& config, std::optional<Keys> keys, Origins origins, Now now)
    : keys_(std::move(keys)), origins_(std::move(origins)) {
    const std::size_t count = keys_ ? keys_->size() : 1;
    for (std::size_t i = 0; i < count; ++i)
        shares_.emplace_back(keys_ ? keys_->at(i).rate.value_or(config.rate) : config.rate, config.burst, now);
}

std::variant<Visitor, Problem> Access::admit(const Request& head) {
    if (is_open_to_all(head)) return Visitor{};
    std::size_t share = 0;
    if (keys_) {
        const Credentials shown = credentials_of(head.headers);
        const std::optional<std::size_t> found = shown.key.empty() ? std::nullopt : keys_->find(shown.key);
        if (!found) return unauthorized(shown.is_given);
        share = *found;
    }
    const std::uint64_t bytes = announced_bytes(head);
    if (const std::optional<double> wait = shares_[share].admit(kUnitsPerRequest + units_of(bytes)))
        return over_share(*wait);
    return Visitor{share, bytes};
}

void Access::charge(const Visitor& visitor, const double worker_seconds, const std::uint64_t body_bytes) {
    if (!visitor.share) return;
    const double unpaid = std::max(0.0, units_of(body_bytes) - units_of(visitor.paid_bytes));
    shares_.at(*visitor.share).charge(std::max(0.0, worker_seconds) * kUnitsPerSecond + unpaid);
}

std::optional<Response> Access::preflight(const Request& head) const {
    if (!origins_.is_preflight(head)) return {};
    const std::string allow = allowed_methods(head.path);
    if (allow.empty()) return {};
    return origins_.preflight(head, allow);
}

}  // namespace tuftwave::server
