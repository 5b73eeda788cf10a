#include "api/moved_character.hpp"

#include <string>

#include "api/motion_file.hpp"
#include "tuftwave/motion.hpp"

namespace tuftwave::server {
namespace {

Problem in_query(const Error& error, const std::string& place = "") {
    return as_query_problem(to_problem(error, place), character_query());
}

std::variant<Schedule, Problem> schedule_for(const CharacterSettings& settings, Format format, const Limits& limits) {
    Timing timing = settings.motion.timing;
    if (const Check wrong = prescribe_rate(format, timing, settings.formulas, limits))
        return in_query(*wrong, "/motion/timing");
    auto schedule = make_schedule(timing, settings.formulas, limits);
    if (!schedule) return in_query(at_prescribed_rate(format, within("/motion/timing", schedule.error())));
    return std::move(schedule).value();
}

Problem wrong_number_of_phases(std::size_t phases, std::size_t chains) {
    return fields_problem({{ProblemCode::kConflict,
                            "?phases",
                            static_cast<double>(phases),
                            "a number for each of the " + std::to_string(chains) + " chains that move",
                            {},
                            {}}});
}

}  // namespace

std::variant<MovedCharacter, Problem> move_character(const Upload& upload, const CharacterSettings& settings,
                                                     Format format, const Context& context) {
    if (settings.motion.one_sided && upload.found.head < 0)
        return fields_problem(
            {{ProblemCode::kDegenerate, "?one_sided", {}, "false, since no node is called a head", {}, {}}});
    auto schedule = schedule_for(settings, format, context.limits);
    if (auto* problem = std::get_if<Problem>(&schedule)) return std::move(*problem);
    auto chosen = choose_chains(upload.found, settings.choice);
    if (auto* problem = std::get_if<Problem>(&chosen)) return std::move(*problem);

    MovedCharacter moved;
    moved.indices = std::get<std::vector<std::size_t>>(std::move(chosen));
    if (!settings.phases.empty() && settings.phases.size() != moved.indices.size())
        return wrong_number_of_phases(settings.phases.size(), moved.indices.size());
    for (const std::size_t index : moved.indices) {
        moved.found.push_back(upload.found.chains[index]);
        moved.chains.push_back(character::to_chain(upload.character, upload.found, moved.found.back()));
        if (!settings.phases.empty()) moved.chains.back().phase = settings.phases[moved.chains.size() - 1];
    }
    if (const Check wrong = check_chains(moved.chains, context.limits)) return to_problem(*wrong, "/chains");
    moved.motion.schedule = std::get<Schedule>(std::move(schedule));
    auto motions = move_chains(moved.chains, settings.motion, moved.motion.schedule, context.limits, context.for_each,
                               context.stop);
    if (!motions) return in_query(motions.error());
    moved.motion.chains = std::move(motions).value();
    return moved;
}

std::vector<character::NodeKeys> node_keys(const Upload& upload, const MovedCharacter& moved) {
    std::vector<character::NodeKeys> keys;
    const auto pictures = static_cast<std::size_t>(moved.motion.schedule.pictures);
    for (std::size_t c = 0; c < moved.found.size(); ++c) {
        const std::size_t nodes = moved.chains[c].nodes.size();
        for (std::size_t i = 0; i < moved.found[c].bones.size(); ++i) {
            character::NodeKeys& node = keys.emplace_back(character::NodeKeys{moved.found[c].bones[i], {}});
            for (std::size_t n = 0; n < pictures; ++n) {
                const Quat& rotation = moved.motion.chains[c].rotations[n * nodes + i];
                node.rotations.push_back(character::to_node_rotation(upload.character, moved.found[c], i, rotation));
            }
        }
    }
    return keys;
}

}  // namespace tuftwave::server
