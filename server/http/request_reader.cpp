#include "http/request_reader.hpp"

#include <algorithm>
#include <utility>

namespace tuftwave::server {

bool RequestReader::refuse(const int status) {
    refusal_ = status;
    return false;
}

/// Looks at each byte as it comes, so that what can never become a head is refused at once and not when time is up.
/// @return  whether the head is complete
bool RequestReader::take_head(std::string_view& bytes) {
    text_.reserve(std::min(text_.size() + bytes.size(), kMostHeadBytes + 1));
    while (!bytes.empty()) {
        const char byte = bytes.front();
        bytes.remove_prefix(1);
        const char previous = text_.empty() ? '\0' : text_.back();
        const bool is_first_line = lines_ == 0;
        if ((byte == '\n') != (previous == '\r') || byte == '\0') return refuse(400);
        if (is_first_line && byte != '\r' && byte != '\n' && (byte < ' ' || byte == '\x7f')) return refuse(400);
        text_ += byte;
        if (is_first_line && text_.size() > kMostFirstLineBytes) return refuse(414);
        if (text_.size() > kMostHeadBytes) return refuse(431);
        if (byte != '\n') continue;
        const std::string_view line = std::string_view(text_).substr(line_begin_, text_.size() - line_begin_ - 2);
        if (is_first_line) {
            if (const int fault = fault_of_first_line(line); fault != 0) return refuse(fault);
        } else if (line.empty()) {
            return true;
        }
        if (lines_++ > kMostHeaders) return refuse(431);
        line_begin_ = text_.size();
    }
    return false;
}

RequestReader::Step RequestReader::take_body(std::string_view& bytes) {
    std::string& body = head_.request.body;
    if (!head_.is_chunked) {
        const std::size_t part = std::min(body_bytes_left(), bytes.size());
        body.append(bytes, 0, part);
        bytes.remove_prefix(part);
        return body.size() == head_.length ? Step::kRequest : Step::kWantsMore;
    }
    switch (chunks_.take(bytes, body, most_body_bytes_)) {
        case ChunkReader::Step::kWantsMore:
            return Step::kWantsMore;
        case ChunkReader::Step::kDone:
            return Step::kRequest;
        case ChunkReader::Step::kBroken:
            refuse(400);
            return Step::kRefused;
        case ChunkReader::Step::kTooLong:
            refuse(413);
            return Step::kRefused;
    }
    return Step::kRefused;
}

RequestReader::Step RequestReader::take(std::string_view& bytes) {
    if (refusal_ != 0) return Step::kRefused;
    if (is_in_body_) return take_body(bytes);
    if (!take_head(bytes)) return refusal_ != 0 ? Step::kRefused : Step::kWantsMore;
    head_ = parse_head(text_);
    if (head_.fault == 0) return Step::kHead;
    refuse(head_.fault);
    return Step::kRefused;
}

void RequestReader::allow_body(const std::size_t most) {
    is_in_body_ = true;
    most_body_bytes_ = most;
    if (head_.length > most) refuse(413);
    if (refusal_ == 0) head_.request.body.reserve(static_cast<std::size_t>(head_.length));
}

Request RequestReader::take_request() {
    Request request = std::move(head_.request);
    *this = {};
    return request;
}

std::size_t RequestReader::body_bytes_left() const {
    return (head_.is_chunked ? most_body_bytes_ : static_cast<std::size_t>(head_.length)) - body_bytes();
}

}  // namespace tuftwave::server
