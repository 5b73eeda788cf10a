#include "http/framing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace tuftwave::server {
namespace {

constexpr std::size_t kReadBytes = 16 * 1024;
constexpr std::uint64_t kDrainFactor = 4;
constexpr std::size_t kLongestChunkLine = 256;  // a length and whatever extensions somebody sends
constexpr int kMostTrailers = 64;

std::optional<std::string> decoded(const std::string_view text, const bool plus_is_space) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '+' && plus_is_space) {
            out += ' ';
        } else if (text[i] != '%') {
            out += text[i];
        } else {
            const std::string_view digits = text.substr(i + 1, 2);
            unsigned char byte = 0;
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
            if (error != std::errc{} || digits.size() != 2 || end != digits.data() + 2) return {};
            out += static_cast<char>(byte);
            i += 2;
        }
    }
    return out;
}

/// What stands before the separator; `text` keeps what stands behind it.
std::string_view cut(std::string_view& text, const char separator) {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

bool is_token(const std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](const char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
    });
}

bool equal_ignoring_case(const std::string_view a, const std::string_view b) {
    const auto lower = [](const char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](const char x, const char y) { return lower(x) == lower(y); });
}

auto count_of(const NameValues& headers, const std::string_view name) {
    return std::count_if(headers.begin(), headers.end(), [&](const auto& header) { return header.first == name; });
}

/// Digits only: no sign, no space, no fraction.
template <class Number>
std::optional<Number> whole_number(const std::string_view text, const int base) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

bool may_have_body(const std::string& method) {
    return method == "POST" || method == "PUT" || method == "PATCH" || method == "DELETE";
}

constexpr Framing kBadRequest{400, false, 0};

/// Takes a body in, stores what fits, and knows when enough is enough.
class BodyReader {
  public:
    BodyReader(const ByteSource& source, const std::size_t limit) : source_(source), limit_(limit) {}

    /// @return  false if the source failed or ended before
    bool take(std::uint64_t count) {
        std::array<char, kReadBytes> buffer;
        while (count > 0 && !is_hopeless()) {
            const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(count, buffer.size()));
            const std::ptrdiff_t got = source_(buffer.data(), wanted);
            if (got <= 0) return false;
            store({buffer.data(), static_cast<std::size_t>(got)});
            count -= static_cast<std::uint64_t>(got);
        }
        return count == 0;
    }

    /// A line without its CR LF; nothing if it is too long, ends otherwise, or never ends.
    std::optional<std::string> line() {
        std::string text;
        for (char c; text.size() < kLongestChunkLine && source_(&c, 1) == 1; text += c) {
            if (c != '\n') continue;
            if (text.empty() || text.back() != '\r') return {};
            text.pop_back();
            return text;
        }
        return {};
    }

    bool is_too_long() const { return received_ > limit_; }
    bool is_hopeless() const { return received_ > kDrainFactor * limit_; }
    void reserve(const std::uint64_t count) {
        bytes_.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, limit_)));
    }
    std::string bytes() && { return std::move(bytes_); }

  private:
    void store(const std::string_view part) {
        received_ += part.size();
        if (is_too_long()) {
            bytes_ = {};
        } else {
            bytes_ += part;
        }
    }

    const ByteSource& source_;
    const std::uint64_t limit_;
    std::uint64_t received_ = 0;
    std::string bytes_;
};

/// @return  whether the body came to its proper end
bool take_chunks(BodyReader& reader) {
    for (;;) {
        const std::optional<std::string> line = reader.line();
        if (!line) return false;
        std::string_view rest = *line;
        const auto length = whole_number<std::uint64_t>(cut(rest, ';'), 16);
        if (!length) return false;
        if (*length == 0) break;
        if (!reader.take(*length) || reader.line() != "") return false;
    }
    for (int i = 0; i < kMostTrailers; ++i) {
        const std::optional<std::string> trailer = reader.line();
        if (!trailer) return false;
        if (trailer->empty()) return true;
    }
    return false;
}

}  // namespace

std::optional<Target> parse_target(std::string_view target) {
    if (!target.starts_with('/')) return {};
    std::optional<std::string> path = decoded(cut(target, '?'), false);
    if (!path) return {};
    Target parsed{*std::move(path), {}};
    while (!target.empty()) {
        std::string_view value = cut(target, '&');
        if (value.empty()) continue;
        std::optional<std::string> name = decoded(cut(value, '='), true);
        std::optional<std::string> decoded_value = decoded(value, true);
        if (!name || !decoded_value) return {};
        parsed.query.emplace_back(*std::move(name), *std::move(decoded_value));
    }
    return parsed;
}

Framing framing_of(const Request& request, const bool is_http_1_0) {
    const auto hosts = count_of(request.headers, "host"), lengths = count_of(request.headers, "content-length"),
               encodings = count_of(request.headers, "transfer-encoding");
    if (hosts > 1 || (hosts == 0 && !is_http_1_0) || lengths > 1 || encodings > 1 || lengths + encodings > 1)
        return kBadRequest;
    for (const auto& [name, value] : request.headers) {
        if (!is_token(name)) return kBadRequest;
    }
    Framing framing;
    if (lengths == 1) {
        const auto length = whole_number<std::uint64_t>(request.header("content-length"), 10);
        if (!length) return kBadRequest;
        framing.length = *length;
    }
    if (encodings == 1) {
        if (is_http_1_0 || !equal_ignoring_case(request.header("transfer-encoding"), "chunked")) return kBadRequest;
        framing.is_chunked = true;
    }
    const bool has_body = framing.is_chunked || framing.length > 0;
    if (has_body && !may_have_body(request.method)) return kBadRequest;
    // Unpacking what a client packed is how half a megabyte becomes five hundred.
    const std::string& coding = request.header("content-encoding");
    if (has_body && !coding.empty() && !equal_ignoring_case(coding, "identity")) framing.fault = 415;
    if (lengths + encodings == 0 && may_have_body(request.method) && request.method != "DELETE") framing.fault = 411;
    return framing;
}

Body read_body(const ByteSource& source, const Framing& framing, const std::size_t limit) {
    BodyReader reader(source, limit);
    if (!framing.is_chunked) {
        if (framing.length > kDrainFactor * limit) return {413, false, ""};
        if (framing.length <= limit) reader.reserve(framing.length);
    }
    const bool is_over = framing.is_chunked ? take_chunks(reader) : reader.take(framing.length);
    if (reader.is_too_long()) return {413, is_over, ""};
    if (!is_over) return {400, false, ""};
    return {0, true, std::move(reader).bytes()};
}

}  // namespace tuftwave::server
