#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tuftwave::server {

/// Takes a chunked body apart (RFC 9112, section 7.1), however its bytes are split. Extensions and trailers are read
/// and dropped.
class ChunkReader {
  public:
    enum class Step {
        kWantsMore,
        kDone,     ///< what is left of the bytes is the next request's
        kBroken,   ///< not well-formed
        kTooLong,  ///< more than allowed
    };

    /// @param bytes  shortened by what was taken
    /// @param body   appended to, up to `most` bytes
    Step take(std::string_view& bytes, std::string& body, std::size_t most);

  private:
    enum class Part { kSize, kData, kDataEnd, kTrailer };

    bool take_line(std::string_view& bytes);
    bool begin_chunk();

    Part part_ = Part::kSize;
    std::string line_;
    bool is_line_too_long_ = false;
    std::uint64_t left_ = 0;  // of the chunk
    int trailers_ = 0;
};

}  // namespace tuftwave::server
