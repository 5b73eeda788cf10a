#include "http/chunk_reader.hpp"

#include <algorithm>
#include <charconv>

namespace tuftwave::server {
namespace {

constexpr std::size_t kMostLineBytes = 256;  // a length and whatever extensions somebody sends
constexpr int kMostTrailers = 16;
constexpr std::size_t kMostSizeDigits = 16;

bool is_printable(const std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](const char c) { return (c >= ' ' && c < '\x7f') || c == '\t'; });
}

}  // namespace

/// Adds to the line. @return  whether it has its end, or is too long for one
bool ChunkReader::take_line(std::string_view& bytes) {
    const std::size_t end = bytes.find('\n');
    const std::size_t part = std::min(end == std::string_view::npos ? bytes.size() : end + 1, kMostLineBytes);
    line_.append(bytes, 0, part);
    bytes.remove_prefix(part);
    is_line_too_long_ = line_.size() > kMostLineBytes;
    return is_line_too_long_ || line_.ends_with('\n');
}

/// Reads the line as a chunk's size.
bool ChunkReader::begin_chunk() {
    const std::string_view text = std::string_view(line_).substr(0, line_.size() - 2);
    const std::string_view digits = text.substr(0, text.find(';'));
    if (digits.size() > kMostSizeDigits || !is_printable(text)) return false;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), left_, 16);
    return error == std::errc{} && end == digits.data() + digits.size();
}

ChunkReader::Step ChunkReader::take(std::string_view& bytes, std::string& body, const std::size_t most) {
    while (!bytes.empty()) {
        if (part_ == Part::kData) {
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left_, bytes.size()));
            body.append(bytes, 0, count);
            bytes.remove_prefix(count);
            left_ -= count;
            if (left_ == 0) part_ = Part::kDataEnd;
            continue;
        }
        if (!take_line(bytes)) continue;
        if (is_line_too_long_ || !line_.ends_with("\r\n")) return Step::kBroken;
        const bool is_blank = line_.size() == 2;
        if (part_ == Part::kSize) {
            if (!begin_chunk()) return Step::kBroken;
            if (left_ > most - body.size()) return Step::kTooLong;
            part_ = left_ == 0 ? Part::kTrailer : Part::kData;
        } else if (part_ == Part::kDataEnd) {
            if (!is_blank) return Step::kBroken;
            part_ = Part::kSize;
        } else {
            if (is_blank) return Step::kDone;
            if (++trailers_ > kMostTrailers) return Step::kBroken;
        }
        line_.clear();
    }
    return Step::kWantsMore;
}

}  // namespace tuftwave::server
