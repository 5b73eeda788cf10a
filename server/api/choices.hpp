#pragma once

#include <string_view>

#include "api/reader.hpp"
#include "character/found_chains.hpp"
#include "gltf/hair_file.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

// The words of the API for core's enumerations, used for reading and for writing.

inline constexpr Choices<Formulas, 2> kFormulas{
    {{"corrected", Formulas::kCorrected}, {"as_printed", Formulas::kAsPrinted}}};
inline constexpr Choices<Taper, 4> kTapers{
    {{"sine", Taper::kSine}, {"linear", Taper::kLinear}, {"smooth", Taper::kSmooth}, {"round", Taper::kRound}}};
inline constexpr Choices<Section, 2> kSections{{{"circle", Section::kCircle}, {"ellipse", Section::kEllipse}}};
inline constexpr Choices<FillKind, 3> kFillKinds{
    {{"along", FillKind::kAlong}, {"crown", FillKind::kCrown}, {"neck", FillKind::kNeck}}};
inline constexpr Choices<FillDirection, 3> kFillDirections{{{"counter_clockwise", FillDirection::kCounterClockwise},
                                                            {"clockwise", FillDirection::kClockwise},
                                                            {"shorter", FillDirection::kShorter}}};
inline constexpr Choices<Spacing, 3> kSpacings{
    {{"diameter", Spacing::kDiameter}, {"half_gap", Spacing::kHalfGap}, {"as_printed", Spacing::kAsPrinted}}};
inline constexpr Choices<Arc, 2> kArcs{{{"spherical", Arc::kSpherical}, {"path", Arc::kPath}}};
inline constexpr Choices<ShortHolds, 2> kShortHolds{{{"last", ShortHolds::kLast}, {"spread", ShortHolds::kSpread}}};
inline constexpr Choices<Sampling, 2> kSamplings{{{"uniform", Sampling::kUniform}, {"by_frame", Sampling::kByFrame}}};
inline constexpr Choices<Mode, 2> kModes{{{"relative", Mode::kRelative}, {"absolute", Mode::kAbsolute}}};
inline constexpr Choices<Droop, 2> kDroops{{{"remove", Droop::kRemove}, {"keep", Droop::kKeep}}};
inline constexpr Choices<PhaseStep, 2> kPhaseSteps{{{"free", PhaseStep::kFree}, {"picture", PhaseStep::kPicture}}};
inline constexpr Choices<gltf::Layout, 2> kLayouts{
    {{"per_tuft", gltf::Layout::kPerTuft}, {"merged", gltf::Layout::kMerged}}};

inline constexpr Choices<character::Kind, 4> kKinds{{{"hair", character::Kind::kHair},
                                                     {"skirt", character::Kind::kSkirt},
                                                     {"ribbon", character::Kind::kRibbon},
                                                     {"unknown", character::Kind::kUnknown}}};
inline constexpr Choices<character::FoundBy, 3> kFoundBy{{{"vrm1_spring", character::FoundBy::kVrm1Spring},
                                                          {"vrm0_bone_group", character::FoundBy::kVrm0BoneGroup},
                                                          {"skin_joints", character::FoundBy::kSkin}}};
inline constexpr Choices<gltf::Holding, 3> kHoldings{
    {{"step", gltf::Holding::kStep}, {"held", gltf::Holding::kHeld}, {"per_frame", gltf::Holding::kPerFrame}}};

inline constexpr Choices<gltf::ClipKind, 2> kClipKinds{
    {{"skeleton", gltf::ClipKind::kSkeleton}, {"flip_book", gltf::ClipKind::kFlipBook}}};

inline constexpr Choices<gltf::Compression, 2> kCompressions{
    {{"none", gltf::Compression::kNone}, {"meshopt", gltf::Compression::kMeshopt}}};

template <class Enum, std::size_t count>
std::string_view word_of(const Choices<Enum, count>& choices, Enum meaning) {
    for (const auto& [word, value] : choices) {
        if (value == meaning) return word;
    }
    return "";
}

}  // namespace tuftwave::server
