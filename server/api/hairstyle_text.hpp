#pragma once

#include <string>

#include "gltf/hair_file.hpp"
#include "tuftwave/for_each.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

/// Appends a hairstyle and how it looks as JSON text, its keys in alphabetical order, with every digit of its numbers.
/// Defaults are written out, so that it reads back to the same one even if a default should change; what is unset stays
/// out. Without a tree of values, which takes 30 times the memory of its text and more time than to mesh a tuft. The
/// same for any `for_each`.
void append_hairstyle(std::string& out, const Hairstyle& hairstyle, const gltf::Look& look, const ForEach& for_each);

}  // namespace tuftwave::server
