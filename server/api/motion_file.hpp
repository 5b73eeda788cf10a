#pragma once

#include <span>
#include <string>
#include <vector>

#include "api/file_options.hpp"
#include "api/formats.hpp"
#include "api/operation.hpp"
#include "poses/posed_hair.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

/// Chains in motion, and what their files and problems call them.
struct MovedChains {
    std::span<const Chain> chains;
    const HairMotion& motion;
    std::string kind;                 ///< what generated names begin with: "tuft" or "chain"
    std::string pointer;              ///< the list in the body that they come from
    std::string file;                 ///< what a file is called
    std::vector<std::string> blocks;  ///< what is drawn together, for the tracks of a sheet; may say the same twice
    poses::BoneNames names = {};      ///< of the bones, chain by chain; empty: as in a GLB of the same chains
};

/// Whether a format tells of motion alone: all but meshes, clips and JSON.
bool is_motion_file(Format format);

/// Takes the frame rate that a format prescribes, whatever was asked for: a VMD has 30 frames per second.
/// @errors  those of make_schedule for a rate that is none
Check prescribe_rate(Format format, Timing& timing, Formulas formulas, const Limits& limits);

/// Says in a problem with a timing that a format prescribes the rate.
Error at_prescribed_rate(Format format, Error error);

/// Whether a clip is small enough. With a key per picture it always is: poses are limited before they are made.
/// @errors  too_many (joints times keys)
Check check_clip(std::span<const Chain> chains, const Schedule& schedule, gltf::Holding holding,
                 const std::string& pointer, const Limits& limits);

/// An exposure sheet, or poses for a tool. @param format  one of is_motion_file()
/// @return  too_many where the file would be too large
Answer motion_file(const MovedChains& moved, Format format, const FileOptions& options, const Limits& limits);

}  // namespace tuftwave::server
