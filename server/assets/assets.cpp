#include "assets/assets.hpp"

#include <cstddef>

// embedded.inc has one line TUFTWAVE_ASSET(symbol, name) for each file; embed.cmake writes it.
#define TUFTWAVE_ASSET(symbol, name) extern "C" const char symbol[], symbol##_end[];
#include "embedded.inc"
#undef TUFTWAVE_ASSET

namespace tuftwave::server {

std::optional<std::string_view> asset(const std::string_view name) {
#define TUFTWAVE_ASSET(symbol, file) \
    if (name == file) return std::string_view(symbol, static_cast<std::size_t>(symbol##_end - symbol));
#include "embedded.inc"
#undef TUFTWAVE_ASSET
    return {};
}

}  // namespace tuftwave::server
