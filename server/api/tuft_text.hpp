#pragma once

#include <string>

#include "tuftwave/tuft.hpp"

namespace tuftwave::server {

/// Appends a tuft as JSON text, its keys in alphabetical order, with every digit of its numbers: what tuft_json() says,
/// without a tree of values, since a file holds every tuft that it was made from.
void append_tuft(std::string& out, const Tuft& tuft);

}  // namespace tuftwave::server
