#pragma once

#include <stop_token>
#include <vector>

#include "tuftwave/hairstyle.hpp"

namespace tuftwave {

/// Makes all fills of a hairstyle, after all have been worked out and found to be not too many.
/// @param hairstyle  its head checked
/// @errors  those of plan_fill below "/fills/0" ... or, for what is wrong with a drawn tuft, "/tufts/0" ...; too_many
///          (fills; tufts or points in all, with their number), cancelled
Result<std::vector<Filled>> fill_hairstyle(const Hairstyle& hairstyle, const Limits& limits, const ForEach& for_each,
                                           const std::stop_token& stop);

}  // namespace tuftwave
