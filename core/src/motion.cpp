// Based on: K. Furukawa, S. Nakata. Automatic Generation of the Periodic Hair Motion of 3D Characters for Anime
// Production. ICEC 2018. Section 2, discretisation in space.
// Differs: angles are those of chords, not of node tangents (half a bone out of phase); they are applied as turns in
// model space, so that rest rotations of any kind survive; besides the paper's horizontal line there is a mode that
// adds the wave to the rest pose.
#include "tuftwave/motion.hpp"

#include <cmath>

#include "swing.hpp"
#include "tuftwave/random.hpp"
#include "tuftwave/vector_checks.hpp"

namespace tuftwave {
namespace {

Error conflict(std::string field, std::variant<std::monostate, double, std::string> given, std::string allowed) {
    return {ErrorCode::kConflict, std::move(field), std::move(given), std::move(allowed), {}, {}};
}

Check check_cycles(int cycles, const Schedule& schedule, const std::string& field) {
    if (cycles == 1 || 2 * cycles < schedule.pictures) return {};
    return conflict(field, static_cast<double>(cycles),
                    "1, or fewer than half of the " + std::to_string(schedule.pictures) + " pictures");
}

Check check_chains(std::span<const Chain> chains, const Motion& motion, const Schedule& schedule,
                   const Limits& limits) {
    std::size_t poses = 0;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const auto place = [&] { return "/" + std::to_string(i); };
        if (motion.one_sided && !chains[i].outward)
            return Error{ErrorCode::kDegenerate,
                         place() + "/outward",
                         {},
                         "a direction, since motion.one_sided is true",
                         {},
                         {}};
        if (chains[i].cycles) {
            if (Check wrong = check_cycles(*chains[i].cycles, schedule, place() + "/cycles")) return wrong;
        }
        poses += chains[i].nodes.size() * static_cast<std::size_t>(schedule.pictures);
    }
    return check_total(poses, limits.node_poses, "nodes times pictures in all chains", "");
}

/// How far a chain runs ahead, radians. @param index  of the chain, for the scatter
double chain_phase(const Chain& chain, std::size_t index, const Motion& motion) {
    double phase = chain.phase;
    if (motion.phase.gust_wavelength) {
        // A gust reaches a root later, the further it lies down the wind. Whole cycles are left out: they change
        // nothing but the size of the number.
        const double cycles = dot(chain.nodes.front(), normalized(motion.wind)) / *motion.phase.gust_wavelength;
        phase -= 2 * kPi * (cycles - std::trunc(cycles));
    }
    if (motion.phase.spread > 0) {
        const std::uint64_t seed = motion.phase.seed;
        const auto words =
            philox4x32({static_cast<std::uint32_t>(index), 0, static_cast<std::uint32_t>(RandomUse::kPhase), 0},
                       {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
        phase += motion.phase.spread * 2 * kPi * unit_interval(words[0], words[1]);
    }
    return phase;
}

/// A phase as it is used: a number of radians, or a number of whole pictures.
struct ChainPhase {
    double radians = 0;
    int pictures = 0;
};

ChainPhase used_phase(double phase, const Motion& motion, const Schedule& schedule) {
    if (motion.phase.step == PhaseStep::kFree) return {phase, 0};
    const double pictures = phase / (2 * kPi) * schedule.pictures;
    return {0, static_cast<int>(pictures < 0 ? pictures - 0.5 : pictures + 0.5)};
}

/// Chooses between q and -q, which are one rotation: w >= 0 in the first picture, then the sign nearer to the one
/// before.
void make_continuous(std::vector<Quat>& rotations, std::size_t nodes) {
    for (std::size_t at = 0; at < rotations.size(); ++at) {
        const double agreement = at < nodes ? rotations[at].w : dot(rotations[at], rotations[at - nodes]);
        if (agreement < 0) rotations[at] = -rotations[at];
    }
}

/// What the motion's options leave out of each bone's angles.
Shift shift_of(const Motion& motion) {
    if (motion.one_sided) return Shift::kLeast;
    const Droop usual = motion.mode == Mode::kRelative ? Droop::kRemove : Droop::kKeep;
    return motion.droop.value_or(usual) == Droop::kRemove ? Shift::kMean : Shift::kNone;
}

ChainMotion move_chain(const Chain& chain, std::size_t index, const Motion& motion, const Schedule& schedule,
                       Vectors vectors) {
    const ChainPhase ahead = used_phase(chain_phase(chain, index, motion), motion, schedule);
    const int cycles = chain.cycles.value_or(motion.phase.cycles);
    std::vector<double> phases(static_cast<std::size_t>(schedule.pictures));
    for (int n = 0; n < schedule.pictures; ++n)
        phases[static_cast<std::size_t>(n)] = picture_phase(schedule, n, cycles, ahead.pictures) + ahead.radians;
    return {ahead.radians + 2 * kPi * ahead.pictures / schedule.pictures,
            swing(chain, motion, phases, shift_of(motion), vectors)};
}

}  // namespace

Check check_motion(const Motion& motion, const Schedule& schedule, const Limits& limits) {
    if (Check wrong = check_wave(motion.wave, limits)) return within("/wave", *wrong);
    if (Check wrong = check_direction(motion.wind, limits, "/wind")) return wrong;
    if (Check wrong = check_direction(motion.up, limits, "/up")) return wrong;
    if (Check wrong = check_not_parallel(motion.wind, motion.up, "/wind", "up")) return wrong;
    if (motion.lift) {
        if (Check wrong = check_range(*motion.lift, limits.lift, "/lift")) return wrong;
    }
    if (motion.one_sided && motion.mode == Mode::kAbsolute)
        return conflict("/one_sided", "true", "false in absolute mode");
    const Phasing& phase = motion.phase;
    if (phase.gust_wavelength) {
        if (Check wrong = check_range(*phase.gust_wavelength, limits.gust_wavelength, "/phase/gust_wavelength"))
            return wrong;
    }
    if (Check wrong = check_range(phase.spread, limits.spread, "/phase/spread")) return wrong;
    if (Check wrong = check_range(phase.cycles, limits.cycles, "/phase/cycles")) return wrong;
    return check_cycles(phase.cycles, schedule, "/phase/cycles");
}

Result<std::vector<ChainMotion>> move_chains(std::span<const Chain> chains, const Motion& motion,
                                             const Schedule& schedule, const Limits& limits, const ForEach& for_each,
                                             std::stop_token stop, Vectors vectors) {
    if (Check wrong = check_motion(motion, schedule, limits)) return within("/motion", *wrong);
    if (Check wrong = check_chains(chains, motion, schedule, limits)) return within("/chains", *wrong);
    std::vector<ChainMotion> moved(chains.size());
    for_each(chains.size(), [&](std::size_t i) {
        if (!stop.stop_requested()) moved[i] = move_chain(chains[i], i, motion, schedule, vectors);
    });
    if (stop.stop_requested()) return Error{ErrorCode::kCancelled, "", {}, "", {}, {}};
    return moved;
}

std::vector<Vec3> node_positions(const Chain& chain, std::span<const Quat> rotations) {
    std::vector<Vec3> positions{chain.nodes.front()};
    Quat rest = normalized(chain.parent_rotation), posed = rest;
    for (std::size_t i = 0; i + 1 < chain.nodes.size(); ++i) {
        rest = rest * normalized(chain.rest_rotations[i]);
        posed = posed * rotations[i];
        const Vec3 bone = rotated(inverse(rest), chain.nodes[i + 1] - chain.nodes[i]);
        positions.push_back(positions.back() + rotated(posed, bone));
    }
    return positions;
}

std::vector<Quat> model_turns(const Chain& chain, std::span<const Quat> rotations) {
    const std::size_t nodes = chain.nodes.size();
    std::vector<Quat> turns;
    turns.reserve(rotations.size());
    for (std::size_t at = 0; at < rotations.size(); at += nodes) {
        Quat rest = normalized(chain.parent_rotation), posed = rest;
        for (std::size_t i = 0; i < nodes; ++i) {
            rest = rest * normalized(chain.rest_rotations[i]);
            posed = posed * rotations[at + i];
            turns.push_back(normalized(posed * inverse(rest)));
        }
    }
    make_continuous(turns, nodes);
    return turns;
}

}  // namespace tuftwave
