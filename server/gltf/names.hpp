#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "tuftwave/skeleton.hpp"

namespace tuftwave::server::gltf {

/// Hands out names that survive every target: unique, ASCII letters, digits and underscores, at most 15 bytes even with
/// a joint number behind them, and free of endings that engines act on.
class Names {
  public:
    /// @param wanted  what a person called it; kept when it survives
    /// @param kind    what a generated name begins with, at most 5 bytes, e.g. "tuft"
    /// @return  `wanted`, or `kind` and a running number such as "tuft_0007"
    std::string claim(const std::string& wanted, const std::string& kind);

    /// The name of a joint of the tuft or chain called `base`. @param number  from 1
    static std::string joint(const std::string& base, std::size_t number);

  private:
    bool collides(
        const std::string& name) const;  ///< with a joint of another tuft, or one of its own joints with a tuft

    std::set<std::string> taken_{"hair_root"};
    int next_ = 1;
};

/// A name for each chain, from what it is called. @param kind  "tuft" or "chain"
std::vector<std::string> claim_names(std::span<const Chain> chains, const std::string& kind);

}  // namespace tuftwave::server::gltf
