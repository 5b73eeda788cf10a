#include "poses/posed_hair.hpp"

#include <charconv>
#include <map>
#include <set>

namespace tuftwave::server::poses {

std::vector<Quat> bone_turns(const Chain& chain, std::span<const Quat> rotations) {
    const std::size_t nodes = chain.nodes.size();
    std::vector<Quat> turns(rotations.size());
    Quat parent = normalized(chain.parent_rotation);
    for (std::size_t i = 0; i < nodes; ++i) {
        const Quat rest = parent * normalized(chain.rest_rotations[i]);
        for (std::size_t at = i; at < rotations.size(); at += nodes)
            turns[at] = normalized(parent * rotations[at] * inverse(rest));
        parent = rest;
    }
    return turns;
}

BoneNames legal_names(const BoneNames& names, bool (*is_allowed)(char), const std::string& taken) {
    std::set<std::string> used{taken};
    std::map<std::string, int> next;  // number to try for a name that is used
    BoneNames legal;
    for (const std::vector<std::string>& chain : names) {
        std::vector<std::string>& made = legal.emplace_back();
        for (std::string name : chain) {
            for (char& c : name) c = is_allowed(c) ? c : '_';
            if (name.empty() || (name.front() >= '0' && name.front() <= '9')) name.insert(0, "_");
            std::string unique = name;
            for (int& number = next.try_emplace(name, 2).first->second; !used.insert(unique).second; ++number)
                unique = name + "_" + std::to_string(number);
            made.push_back(std::move(unique));
        }
    }
    return legal;
}

void append_number(std::string& text, double value) {
    char digits[32];
    const float rounded = static_cast<float>(value) + 0.0F;  // which takes the minus off a zero
    text.append(digits, std::to_chars(digits, digits + sizeof digits, rounded).ptr);
}

}  // namespace tuftwave::server::poses
