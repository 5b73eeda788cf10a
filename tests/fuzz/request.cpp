#include "http/request_reader.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "targets.hpp"

namespace tuftwave::server::fuzz {
namespace {

constexpr std::size_t kMostBody = 512;

/// What a reader makes of a connection's bytes: the requests that were complete, and why it stopped.
struct Reading {
    std::vector<Request> requests;
    int refusal = 0;
    std::size_t taken = 0;  // bytes

    bool operator==(const Reading& other) const {
        const auto same = [](const Request& a, const Request& b) {
            return a.method == b.method && a.path == b.path && a.query == b.query && a.headers == b.headers &&
                   a.body == b.body;
        };
        // What was taken of a request that is refused does not matter: nothing more is read from there.
        return refusal == other.refusal && (refusal != 0 || taken == other.taken) &&
               std::equal(requests.begin(), requests.end(), other.requests.begin(), other.requests.end(), same);
    }
};

bool is_text(const std::string& value) {
    return value.find_first_of(std::string_view("\r\n\0", 3)) == std::string::npos;
}

/// What holds of every head that is let through, whatever was sent.
void require_sound(const RequestHead& head) {
    const Request& request = head.request;
    const auto count = [&](const std::string_view name) {
        return std::count_if(request.headers.begin(), request.headers.end(),
                             [&](const auto& header) { return header.first == name; });
    };
    require(
        request.method == "GET" || request.method == "HEAD" || request.method == "POST" || request.method == "OPTIONS",
        "the method is known");
    require(request.path.starts_with('/') && request.path.find('\0') == std::string::npos, "the path is a path");
    require(count("host") <= 1 && (head.is_http_1_0 || count("host") == 1), "there is one Host");
    require(count("content-length") + count("transfer-encoding") <= 1, "the body has one length");
    require(!head.has_body() || request.method == "POST", "only POST has a body");
    require(!head.is_chunked || !head.is_http_1_0, "HTTP/1.0 knows no chunks");
    require(request.headers.size() <= kMostHeaders, "there are no more headers than allowed");
    for (const auto& [name, value] : request.headers)
        require(!name.empty() && is_text(name) && is_text(value), "a header is one line");
}

/// Feeds a reader until it refuses or wants more than there is. @param part  how many of the bytes left come next
template <class Part>
Reading read(const std::string_view input, Part part) {
    Reading reading;
    RequestReader reader;
    std::string_view given;
    std::size_t end = 0;
    for (;;) {
        const std::size_t before = given.size();
        const RequestReader::Step step = reader.take(given);
        require(given.size() <= before, "no more is taken than was given");
        reading.taken += before - given.size();
        if (step == RequestReader::Step::kHead) {
            require_sound(reader.head());
            if (reader.head().has_body()) {
                reader.allow_body(kMostBody);
            } else {
                reading.requests.push_back(reader.head().request);
                reader.skip_body();
            }
        } else if (step == RequestReader::Step::kRequest) {
            reading.requests.push_back(reader.take_request());
            require(reading.requests.back().body.size() <= kMostBody, "no body is longer than allowed");
        } else if (step == RequestReader::Step::kRefused) {
            reading.refusal = reader.refusal();
            return reading;
        } else {
            require(given.empty(), "it wants more only when it has taken all");
            if (end == input.size()) return reading;
            const std::size_t next = std::min(input.size() - end, part());
            given = input.substr(end, next);
            end += next;
        }
    }
}

}  // namespace

/// The first byte says how the rest, a connection's bytes, is split. However it is, the same requests come out.
void run_request(const Target&, const std::string_view input) {
    if (input.empty()) return;
    auto state = static_cast<std::uint32_t>(static_cast<unsigned char>(input.front()));
    const std::string_view bytes = input.substr(1);
    const Reading whole = read(bytes, [&] { return bytes.size(); });
    require(whole.taken <= bytes.size(), "no more is taken than there is");
    require(whole.refusal == 0 || (whole.refusal >= 400 && whole.refusal < 600), "a refusal is a status");
    require(whole == read(bytes, [] { return std::size_t{1}; }), "byte by byte it says the same");
    const auto any_part = [&] {
        state = state * 1'664'525U + 1'013'904'223U;
        return std::size_t{1} + (state >> 24) % 40;
    };
    require(whole == read(bytes, any_part), "in parts it says the same");
}

}  // namespace tuftwave::server::fuzz
