#include "api/choose_chains.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

#include "api/choices.hpp"

namespace tuftwave::server {
namespace {

using Chosen = std::variant<std::vector<std::size_t>, Problem>;

constexpr std::size_t kMostComparisons = 1'073'741'824;  // of bytes: a second

std::vector<std::string_view> split(std::string_view list) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t end = list.find(',');
        words.push_back(list.substr(0, end));
        if (end == std::string_view::npos) return words;
        list.remove_prefix(end + 1);
    }
}

/// Bytes of the UTF-8 character that `text` begins with.
std::size_t character_bytes(std::string_view text) {
    std::size_t bytes = 1;
    while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) ++bytes;
    return bytes;
}

/// Whether a name fits a pattern; on a mismatch the last * takes one byte more, so the cost is at most their product.
bool fits(std::string_view name, std::string_view pattern) {
    std::size_t n = 0, p = 0, star = std::string_view::npos, resume = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = n;
        } else if (p < pattern.size() && pattern[p] == '?') {
            n += character_bytes(name.substr(n));
            ++p;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++n;
            ++p;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++resume;
        } else {
            return false;
        }
    }
    return pattern.substr(p).find_first_not_of('*') == std::string_view::npos;
}

bool is_wanted(const character::FoundChain& chain, std::size_t index, std::string_view word) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc{} && end == word.data() + word.size()) return number == index;
    return fits(chain.name, word);
}

Problem refused(ProblemCode code, const char* parameter, std::string_view word, std::string allowed) {
    return fields_problem({{code, parameter, std::string(word.substr(0, 64)), std::move(allowed), {}, {}}});
}

Chosen by_name(const character::FoundChains& found, std::string_view list) {
    std::size_t bytes = 0;
    for (const character::FoundChain& chain : found.chains) bytes += chain.name.size();
    if (bytes > kMostComparisons / list.size())
        return refused(ProblemCode::kTooMany, "?chains", list,
                       "a shorter list, since the names of the chains have " + std::to_string(bytes) + " bytes");
    std::set<std::size_t> chosen;
    for (const std::string_view word : split(list)) {
        bool is_found = false;
        for (std::size_t i = 0; i < found.chains.size(); ++i) {
            if (!is_wanted(found.chains[i], i, word)) continue;
            chosen.insert(i);
            is_found = true;
        }
        if (!is_found)
            return refused(ProblemCode::kNotAChoice, "?chains", word,
                           "an index below " + std::to_string(found.chains.size()) +
                               ", or a name or pattern of one of the chains that /v1/characters/chains lists");
    }
    return std::vector<std::size_t>(chosen.begin(), chosen.end());
}

Chosen by_kind(const character::FoundChains& found, std::string_view list) {
    std::set<character::Kind> kinds;
    for (const std::string_view word : split(list)) {
        const auto known = std::ranges::find(kKinds, word, &std::pair<std::string_view, character::Kind>::first);
        if (known == kKinds.end())
            return refused(ProblemCode::kNotAChoice, "?kinds", word, "one of hair, skirt, ribbon, unknown");
        kinds.insert(known->second);
    }
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < found.chains.size(); ++i) {
        if (kinds.contains(found.chains[i].kind)) chosen.push_back(i);
    }
    return chosen;
}

}  // namespace

Chosen choose_chains(const character::FoundChains& found, const ChainChoice& choice) {
    if (!choice.chains.empty() && !choice.kinds.empty())
        return refused(ProblemCode::kConflict, "?kinds", choice.kinds, "either chains or kinds");
    if (!choice.chains.empty()) return by_name(found, choice.chains);
    Chosen chosen = by_kind(found, choice.kinds.empty() ? "hair" : choice.kinds);
    if (const auto* none = std::get_if<std::vector<std::size_t>>(&chosen); none != nullptr && none->empty()) {
        const std::string others = std::to_string(found.chains.size());
        return fields_problem(
            {{ProblemCode::kTooFew,
              choice.kinds.empty() ? "" : "?kinds",
              0.0,
              "a file in which a chain of the wanted kinds is found; of all kinds there are " + others,
              1.0,
              {}}});
    }
    return chosen;
}

}  // namespace tuftwave::server
