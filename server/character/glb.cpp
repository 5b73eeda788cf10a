#include "character/glb.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace tuftwave::server::character {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinary = 0x004E4942;  // "BIN" and a zero
constexpr std::uint32_t kVersion = 2;          // of the container
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return number;
}

void append_number(std::string& bytes, std::uint32_t number) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xFF);
}

Fault malformed(const std::string& why) {
    return {Fault::Kind::kMalformed, "", {}, "The file is no GLB: " + why, {}, {}};
}

std::optional<Fault> check_header(std::string_view file) {
    if (file.size() < kHeaderBytes || number_at(file, 0) != kMagic)
        return malformed("it does not begin with \"glTF\".");
    if (number_at(file, 4) != kVersion)
        return malformed("its container has version " + std::to_string(number_at(file, 4)) + "; 2 is understood.");
    if (number_at(file, 8) != file.size())
        return malformed("its header says " + std::to_string(number_at(file, 8)) + " bytes, it has " +
                         std::to_string(file.size()) + ".");
    return {};
}

struct Chunk {
    std::uint32_t type;
    std::string_view content;
};

/// Cuts the first chunk off `rest`, which is not empty.
std::variant<Chunk, Fault> next_chunk(std::string_view& rest) {
    if (rest.size() < kChunkHeaderBytes) return malformed("a chunk's header is cut off.");
    const std::size_t bytes = number_at(rest, 0);
    if (bytes % 4 != 0) return malformed("a chunk's length is no multiple of 4.");
    if (bytes > rest.size() - kChunkHeaderBytes)
        return malformed("a chunk of " + std::to_string(bytes) + " bytes does not fit into the file.");
    const Chunk chunk{number_at(rest, 4), rest.substr(kChunkHeaderBytes, bytes)};
    rest.remove_prefix(kChunkHeaderBytes + bytes);
    return chunk;
}

void append_padded(std::string& bytes, std::string_view content, char padding) {
    bytes += content;
    while (bytes.size() % 4 != 0) bytes += padding;
}

}  // namespace

std::variant<Glb, Fault> split_glb(std::string_view file) {
    if (std::optional<Fault> fault = check_header(file)) return *std::move(fault);
    Glb glb;
    std::string_view rest = file.substr(kHeaderBytes);
    for (int i = 0; !rest.empty(); ++i) {
        const std::string_view whole = rest;
        const auto read = next_chunk(rest);
        if (const auto* fault = std::get_if<Fault>(&read)) return *fault;
        const auto& [type, content] = std::get<Chunk>(read);
        if ((type == kJson) != (i == 0)) return malformed("its first chunk, and no other, must be JSON.");
        if (type == kBinary && i != 1) return malformed("a binary chunk must be the second.");
        if (i == 0) {
            glb.json = content;
        } else if (type == kBinary) {
            glb.binary = content;
        } else if (glb.others.empty()) {
            glb.others = whole;
        }
    }
    if (glb.json.empty()) return malformed("it has no JSON.");
    return glb;
}

std::string join_glb(std::string_view json, std::string_view binary, std::string_view added, std::string_view others) {
    const std::size_t json_bytes = (json.size() + 3) / 4 * 4, binary_bytes = binary.size() + added.size();
    const std::size_t binary_chunk = binary_bytes == 0 ? 0 : kChunkHeaderBytes + binary_bytes;
    const std::size_t bytes = kHeaderBytes + kChunkHeaderBytes + json_bytes + binary_chunk + others.size();
    std::string file;
    file.reserve(bytes);
    append_number(file, kMagic);
    append_number(file, kVersion);
    append_number(file, static_cast<std::uint32_t>(bytes));
    append_number(file, static_cast<std::uint32_t>(json_bytes));
    append_number(file, kJson);
    append_padded(file, json, ' ');
    if (binary_bytes != 0) {
        append_number(file, static_cast<std::uint32_t>(binary_bytes));
        append_number(file, kBinary);
        file += binary;
        file += added;
    }
    file += others;
    return file;
}

}  // namespace tuftwave::server::character
