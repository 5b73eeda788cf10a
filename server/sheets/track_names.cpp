#include "sheets/track_names.hpp"

#include <array>
#include <set>
#include <string_view>

namespace tuftwave::server::sheets {
namespace {

/// What readers take for blanks, as UTF-8: also the no-break space and the one as wide as a Japanese character.
constexpr std::array<std::string_view, 8> kBlanks{" ", "\t", "\n", "\v", "\f", "\r", "\u00a0", "\u3000"};

std::string_view trimmed(std::string_view text) {
    for (bool again = true; again;) {
        again = false;
        for (const std::string_view blank : kBlanks) {
            if (text.starts_with(blank)) text.remove_prefix(blank.size()), again = true;
            if (text.ends_with(blank)) text.remove_suffix(blank.size()), again = true;
        }
    }
    return text;
}

}  // namespace

std::vector<std::string> track_names(std::span<const std::string> blocks) {
    std::vector<std::string> names;
    std::set<std::string_view> seen;
    for (const std::string& block : blocks) {
        std::string_view name = trimmed(block);
        if (name.empty()) name = kHairTrack;
        if (seen.insert(name).second) names.emplace_back(name);
    }
    return names;
}

}  // namespace tuftwave::server::sheets
