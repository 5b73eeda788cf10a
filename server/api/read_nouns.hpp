#pragma once

#include "api/reader.hpp"
#include "gltf/hair_file.hpp"
#include "tuftwave/hairstyle.hpp"

namespace tuftwave::server {

// From JSON to core's structs, one function per noun. They check types and names; core checks the ranges.

inline constexpr std::size_t kLongestName = 64;  // characters

void read_head(JsonValue json, const Place& place, FieldProblems& problems, const Limits& limits, Head& into);
void read_tuft(JsonValue json, const Place& place, FieldProblems& problems, const Limits& limits, Tuft& into);
void read_chain(JsonValue json, const Place& place, FieldProblems& problems, const Limits& limits, Chain& into);
void read_timing(JsonValue json, const Place& place, FieldProblems& problems, const Limits& limits, Timing& into);
void read_motion(JsonValue json, const Place& place, FieldProblems& problems, const Limits& limits, Motion& into);
void read_mesh(JsonValue json, const Place& place, FieldProblems& problems, const Limits& limits, MeshDetail& detail,
               gltf::Look& look);
void read_formulas(Fields& fields, Formulas& into);

/// The settings among the fields of a fill; what it lies between is left to the caller. @param into  with its defaults
void read_fill_settings(Fields& fields, FieldProblems& problems, FillSettings& into);

}  // namespace tuftwave::server
