#include "character/kinds.hpp"

#include <algorithm>
#include <array>

namespace tuftwave::server::character {
namespace {

struct Word {
    std::string_view word;
    NameHint hint;
};

/// Words that may stand anywhere in a name; the first one counts, so that a ribbon in the hair is a ribbon. Katakana
/// also in half width, as MMD's models have it.
constexpr std::array<Word, 49> kParts{
    {{"リボン", NameHint::kRibbon},   {"ﾘﾎﾞﾝ", NameHint::kRibbon},    {"ribbon", NameHint::kRibbon},
     {"ネクタイ", NameHint::kRibbon}, {"ﾈｸﾀｲ", NameHint::kRibbon},    {"紐", NameHint::kRibbon},
     {"髪", NameHint::kHair},         {"かみ", NameHint::kHair},      {"もみあげ", NameHint::kHair},
     {"アホ毛", NameHint::kHair},     {"あほ毛", NameHint::kHair},    {"ｱﾎ毛", NameHint::kHair},
     {"ツインテ", NameHint::kHair},   {"ﾂｲﾝﾃ", NameHint::kHair},      {"ポニテ", NameHint::kHair},
     {"ﾎﾟﾆﾃ", NameHint::kHair},       {"ポニーテ", NameHint::kHair},  {"おさげ", NameHint::kHair},
     {"三つ編み", NameHint::kHair},   {"前毛", NameHint::kHair},      {"hair", NameHint::kHair},
     {"kami", NameHint::kHair},       {"bangs", NameHint::kHair},     {"fringe", NameHint::kHair},
     {"ponytail", NameHint::kHair},   {"twintail", NameHint::kHair},  {"ahoge", NameHint::kHair},
     {"braid", NameHint::kHair},      {"スカート", NameHint::kSkirt}, {"ｽｶｰﾄ", NameHint::kSkirt},
     {"skirt", NameHint::kSkirt},     {"裾", NameHint::kSkirt},       {"目", NameHint::kFace},
     {"眉", NameHint::kFace},         {"口", NameHint::kFace},        {"舌", NameHint::kFace},
     {"歯", NameHint::kFace},         {"顎", NameHint::kFace},        {"頬", NameHint::kFace},
     {"瞳", NameHint::kFace},         {"睫", NameHint::kFace},        {"まぶた", NameHint::kFace},
     {"eyebrow", NameHint::kFace},    {"eyelid", NameHint::kFace},    {"eyelash", NameHint::kFace},
     {"耳", NameHint::kOther},        {"帽子", NameHint::kOther},     {"角", NameHint::kOther},
     {"胸", NameHint::kOther}}};

/// Words that must stand alone between capitals, digits and marks: "brow1.l" has one, "brown" has none.
constexpr std::array<Word, 22> kWords{
    {{"bang", NameHint::kHair},     {"tail", NameHint::kOther}, {"tie", NameHint::kRibbon},
     {"string", NameHint::kRibbon}, {"brow", NameHint::kFace},  {"brows", NameHint::kFace},
     {"eye", NameHint::kFace},      {"eyes", NameHint::kFace},  {"jaw", NameHint::kFace},
     {"mouth", NameHint::kFace},    {"lip", NameHint::kFace},   {"lips", NameHint::kFace},
     {"tongue", NameHint::kFace},   {"teeth", NameHint::kFace}, {"nose", NameHint::kFace},
     {"cheek", NameHint::kFace},    {"chin", NameHint::kFace},  {"ear", NameHint::kOther},
     {"ears", NameHint::kOther},    {"hat", NameHint::kOther},  {"bust", NameHint::kOther},
     {"breast", NameHint::kOther}}};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
char to_lower(char c) { return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c; }

std::string lowered(std::string_view text) {
    std::string lower;
    for (const char c : text) lower += to_lower(c);
    return lower;
}

/// The words of "J_Bip_C_Head", "FrontHair.001", "brow1.l": runs of letters, cut before a capital that follows a small
/// letter.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words(1);
    char before = ' ';
    for (const char c : name) {
        const bool is_letter = is_upper(c) || is_lower(c);
        if ((!is_letter || (is_upper(c) && is_lower(before))) && !words.back().empty()) words.emplace_back();
        if (is_letter) words.back() += to_lower(c);
        before = c;
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

bool has_word(const std::vector<std::string>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_called_head(const std::string& name) {
    if (name == "頭" || name == "あたま" || name == "頭部") return true;
    const std::vector<std::string> words = words_of(name);
    // "Head", "J_Bip_C_Head", "mixamorig:Head", but neither "HeadTop_End" nor "headset".
    return has_word(words, "head") && !has_word(words, "end") && !has_word(words, "top") && words.size() <= 4;
}

}  // namespace

std::optional<NameHint> hint_of(std::string_view name) {
    const std::string lower = lowered(name);
    const std::vector<std::string> words = words_of(name);
    for (const auto& [part, hint] : kParts) {
        if (lower.find(part) != std::string::npos) return hint;
    }
    for (const auto& [word, hint] : kWords) {
        if (has_word(words, word)) return hint;
    }
    return {};
}

int find_head(const Character& character) {
    if (const auto head = character.humanoid.find("head"); head != character.humanoid.end()) return head->second;
    for (const int index : character.order) {
        const Node& node = character.nodes[static_cast<std::size_t>(index)];
        if (node.is_joint && is_called_head(node.name)) return index;
    }
    return -1;
}

}  // namespace tuftwave::server::character
