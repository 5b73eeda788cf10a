// libFuzzer's side: tuftwave_fuzz --target=NAME [libFuzzer's options and folders]. See run.py.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "targets.hpp"

namespace {

using tuftwave::server::fuzz::find_target;
using tuftwave::server::fuzz::Target;

const Target* chosen = nullptr;

void put_word(std::uint8_t* at, const std::size_t word) {
    for (std::size_t i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(word >> 8 * i);
}

/// Makes the lengths of a GLB right again, so that a change in its JSON gets past its frame. The second chunk keeps its
/// bytes, wherever they have gone.
void mend_lengths(std::uint8_t* file, const std::size_t size) {
    constexpr std::size_t kHeader = 12, kChunk = 8;
    if (size < kHeader + kChunk) return;
    std::memcpy(file, "glTF\2\0\0\0", 8);
    put_word(file + 8, size);
    std::memcpy(file + kHeader + 4, "JSON", 4);
    std::size_t json = size - kHeader - kChunk;
    for (std::size_t at = kHeader + kChunk; at + kChunk <= size; ++at) {
        if (std::memcmp(file + at + 4, "BIN\0", 4) != 0) continue;
        put_word(file + at, size - at - kChunk);
        json = at - kHeader - kChunk;
        break;
    }
    put_word(file + kHeader, json);
}

}  // namespace

extern "C" {

std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

int LLVMFuzzerInitialize(int* count, char*** arguments) {
    constexpr const char* kFlag = "--target=";
    for (int i = 1; i < *count; ++i) {
        if (std::strncmp((*arguments)[i], kFlag, std::strlen(kFlag)) == 0)
            chosen = find_target((*arguments)[i] + std::strlen(kFlag));
    }
    if (chosen == nullptr) {
        std::fprintf(stderr, "tuftwave_fuzz: --target= takes one of:");
        for (const Target& target : tuftwave::server::fuzz::targets()) std::fprintf(stderr, " %s", target.name.c_str());
        std::fprintf(stderr, "\n");
        std::exit(2);
    }
    return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    chosen->run(*chosen, {reinterpret_cast<const char*>(data), size});
    return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    size = LLVMFuzzerMutate(data, size, most);
    if (!chosen->takes_file || seed % 8 == 0) return size;
    std::size_t begin = 0;  // of the file: behind the query, where there is one
    if (!chosen->path.empty()) {
        const auto* end = static_cast<const std::uint8_t*>(std::memchr(data, '\n', size));
        if (end == nullptr) return size;
        begin = static_cast<std::size_t>(end - data) + 1;
    }
    mend_lengths(data + begin, size - begin);
    return size;
}
}
