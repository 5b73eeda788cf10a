#include "gltf/names.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace tuftwave::server::gltf {
namespace {

constexpr std::size_t kLongestBase = 12;  // and "_01" makes the 15 bytes of a VMD bone name

/// What Godot acts on at the end of a node's name, in any case.
constexpr std::array<std::string_view, 13> kActingEndings{"col",     "convcol", "colonly", "convcolonly", "noimp",
                                                          "navmesh", "occ",     "occonly", "rigid",       "wheel",
                                                          "vehicle", "loop",    "cycle"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool acts_in_engines(const std::string& name) {
    const std::size_t mark = name.find_last_of('_');
    if (mark == std::string::npos) return false;
    std::string ending = name.substr(mark + 1);
    for (char& c : ending) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return std::find(kActingEndings.begin(), kActingEndings.end(), ending) != kActingEndings.end();
}

bool survives(const std::string& name) {
    if (name.empty() || name.size() > kLongestBase || !is_letter(name.front())) return false;
    const bool plain =
        std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
    return plain && !acts_in_engines(name);
}

std::string padded(std::size_t number, std::size_t width) {
    std::string digits = std::to_string(number);
    return digits.size() >= width ? digits : std::string(width - digits.size(), '0') + digits;
}

/// Whether `name` is what a joint of the tuft called `base` may be called.
bool is_joint_of(std::string_view base, std::string_view name) {
    if (name.size() != base.size() + 3 || !name.starts_with(base)) return false;
    const std::string_view number = name.substr(base.size());
    return number[0] == '_' && is_digit(number[1]) && is_digit(number[2]);
}

}  // namespace

bool Names::collides(const std::string& name) const {
    if (const std::size_t mark = name.find_last_of('_'); mark != std::string::npos) {
        const std::string base = name.substr(0, mark);
        if (is_joint_of(base, name) && taken_.contains(base)) return true;
    }
    const std::string first_joint = name + "_";
    for (auto other = taken_.lower_bound(first_joint); other != taken_.end() && other->starts_with(first_joint);
         ++other) {
        if (is_joint_of(name, *other)) return true;
    }
    return false;
}

std::string Names::claim(const std::string& wanted, const std::string& kind) {
    std::string name = wanted;
    while (!survives(name) || taken_.contains(name) || collides(name))
        name = kind + "_" + padded(static_cast<std::size_t>(next_++), 4);
    taken_.insert(name);
    return name;
}

std::string Names::joint(const std::string& base, std::size_t number) { return base + "_" + padded(number, 2); }

std::vector<std::string> claim_names(std::span<const Chain> chains, const std::string& kind) {
    Names names;
    std::vector<std::string> claimed;
    for (const Chain& chain : chains) claimed.push_back(names.claim(chain.name, kind));
    return claimed;
}

}  // namespace tuftwave::server::gltf
