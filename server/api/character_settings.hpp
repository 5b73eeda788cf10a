#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "api/choose_chains.hpp"
#include "api/exchange.hpp"
#include "api/problem.hpp"
#include "api/query_body.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave::server {

/// What becomes of the springs of the chains that move.
enum class Springs { kKeep, kRemove };

/// How the hair of a posted character is to move. It all stands in the query, since the body is the file.
struct CharacterSettings {
    Motion motion;
    Formulas formulas = Formulas::kCorrected;
    ChainChoice choice;
    std::vector<double> phases;  ///< radians, one per chain that moves; empty is 0 for all
    Springs springs = Springs::kKeep;
    std::string clip_name = "wave";
};

/// The parameters of /v1/characters/motion and where they stand in the body that they stand for.
std::span<const QueryField> character_query();

/// @return  what is wrong, with the names of the parameters
std::variant<CharacterSettings, Problem> read_character_settings(const Request& request, const Limits& limits);

}  // namespace tuftwave::server
