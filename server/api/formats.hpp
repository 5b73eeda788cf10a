#pragma once

#include <initializer_list>
#include <string>
#include <variant>

#include "api/exchange.hpp"
#include "api/problem.hpp"
#include "gltf/document.hpp"
#include "tuftwave/schedule.hpp"

namespace tuftwave::server {

/// What an answer can be written as.
enum class Format { kGlb, kGltf, kJson, kXdts, kCsv, kVmd, kBvh, kUsda };

/// Chooses by ?format=, else by Accept with its q values, else the first one offered.
/// @return  not_a_choice for an unknown ?format=, not_acceptable for an Accept that rules out everything
std::variant<Format, Problem> choose_format(const Request& request, std::initializer_list<Format> offered);

/// An answer with its media type, a file name made of `name`, the frame rate and the ending, and, where something
/// moves, the Tuftwave-Frame-Rate header: neither glTF nor XDTS, CSV or VMD stores one.
Response formatted(Format format, std::string body, const std::string& name, const Schedule* schedule);
Response formatted(Format format, gltf::File file, const std::string& name, const Schedule* schedule);

}  // namespace tuftwave::server
