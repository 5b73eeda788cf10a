#include "api/character_chains.hpp"

#include <nlohmann/json.hpp>

#include "api/body.hpp"
#include "api/formats.hpp"
#include "api/read_character.hpp"
#include "api/write_character.hpp"

namespace tuftwave::server {

Answer post_character_chains(const Request& request, const Context& context) {
    if (auto problem = check_query(request, {"format"})) return *std::move(problem);
    auto format = choose_format(request, {Format::kJson});
    if (auto* problem = std::get_if<Problem>(&format)) return std::move(*problem);
    auto read = read_character(request, context.limits);
    if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);
    return formatted(Format::kJson, found_chains_text(std::get<Upload>(read)), "chains", nullptr);
}

}  // namespace tuftwave::server
