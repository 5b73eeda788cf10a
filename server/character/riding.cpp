#include "character/riding.hpp"

#include <algorithm>
#include <numeric>

namespace tuftwave::server::character {

std::vector<std::optional<Ride>> find_rides(const Character& character, std::span<const FoundChain> moved) {
    std::vector<std::optional<Ride>> of_node(character.nodes.size());
    for (std::size_t c = 0; c < moved.size(); ++c) {
        for (std::size_t b = 0; b < moved[c].bones.size(); ++b)
            of_node[static_cast<std::size_t>(moved[c].bones[b])] = Ride{c, b};
    }
    // What a node itself turns with, once its parents know.
    std::vector<std::optional<Ride>> above(character.nodes.size());
    for (const int index : character.order) {
        const auto node = static_cast<std::size_t>(index);
        if (character.nodes[node].parent < 0) continue;
        const auto parent = static_cast<std::size_t>(character.nodes[node].parent);
        above[node] = of_node[parent] ? of_node[parent] : above[parent];
    }
    std::vector<std::optional<Ride>> rides;
    for (const FoundChain& chain : moved) rides.push_back(above[static_cast<std::size_t>(chain.bones.front())]);
    return rides;
}

std::vector<std::size_t> riding_order(const Character& character, std::span<const FoundChain> moved) {
    std::vector<std::size_t> order(moved.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t c) {
        return character.nodes[static_cast<std::size_t>(moved[c].bones.front())].first;
    });
    return order;
}

}  // namespace tuftwave::server::character
