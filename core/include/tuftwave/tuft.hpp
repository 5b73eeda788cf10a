#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tuftwave/head.hpp"
#include "tuftwave/limits.hpp"
#include "tuftwave/math.hpp"
#include "tuftwave/profile.hpp"
#include "tuftwave/reach.hpp"
#include "tuftwave/result.hpp"
#include "tuftwave/ring.hpp"
#include "tuftwave/skeleton.hpp"
#include "tuftwave/wide.hpp"

namespace tuftwave {

/// The outline of a cut across a tuft.
enum class Section { kCircle, kEllipse };

/// Where in a fill a tuft stands: in the row between the two tufts, or copied up to the crown or down to the neck.
enum class FillKind { kAlong, kCrown, kNeck };

/// Which tuft of a fill this is. Travels along with the tuft and changes nothing.
struct Origin {
    FillKind kind = FillKind::kAlong;
    int index = 1;              ///< along: l, from the tuft after the first; copies: y, away from the parent
    std::optional<int> parent;  ///< of copies: o; 1 is the first tuft, 2 the first one along, the second tuft is last

    friend bool operator==(const Origin&, const Origin&) = default;
};

/// A stroke and its shape.
struct Tuft {
    std::string name;
    std::vector<Vec3> points;  ///< the stroke: Q_1 on the scalp first, metres
    double diameter = 40;      ///< d, 1 to 100, share of head.diameter_at_100 in percent
    double widest_at = 40;     ///< p, 1 to 100, percent of the arc length
    Taper taper = Taper::kSine;
    Section section = Section::kCircle;
    double flatness = 0;           ///< of an ellipse: 1 - thickness / diameter; the flat side faces the head
    double twist_deg = 0;          ///< turn of the section from root to tip, degrees
    double roll_deg = 0;           ///< turn of the section all along, degrees; 90 stands an ellipse on its edge
    int joints = 6;                ///< bones of the tuft's chain
    double phase = 0;              ///< radians, for motion
    std::optional<int> cycles;     ///< waves per loop, for motion
    std::optional<Origin> origin;  ///< of a filled tuft
};

/// How finely a tuft is meshed.
struct MeshDetail {
    double tolerance = 3e-4;   ///< largest distance between surface and mesh along the tuft, metres (0.3 mm)
    std::optional<int> rings;  ///< this many rings per tuft, in place of the tolerance
    int sides = 12;            ///< corners of a ring
    bool skin = true;          ///< false: no bones, and vertices that hang on none
};

/// @errors  too_few, too_many (points), not_finite, out_of_range, degenerate (no length; root at the head's center),
///          conflict (a flat circle)
Check check_tuft(const Tuft& tuft, const Head& head, const Limits& limits);
Check check_detail(const MeshDetail& detail, const Limits& limits);

/// A tuft cut into rings: everything about its mesh but the vertices.
struct MeshPlan {
    std::size_t ring_count = 0;
    Vec3 root, tip;                      ///< the apexes of the two ends; the tip is the cap's middle where it is flat
    Vec3 root_direction, tip_direction;  ///< unit, outward at the two ends
    Rings rings;                         ///< without the apexes; none where only the mesh's size is planned
    Reach reach;
    bool flat_tip = false;  ///< p = 100: a cap at full width
    int sides = 0;
    int joints = 0;  ///< bones of the chain that the vertices hang on; 0 without a skin

    std::size_t vertex_count() const;
    std::size_t index_count() const;
};

/// A tuft measured: how to mesh it, and its bones. Without a skin the chain has a name and no nodes.
struct PlannedTuft {
    MeshPlan mesh;
    Chain chain;
};

/// Plans no more than how large a tuft's mesh will be. @param detail  with a number of rings
MeshPlan plan_mesh_size(const Tuft& tuft, const MeshDetail& detail);

/// Measures a tuft and chooses its rings.
/// @errors  those of check_tuft, too_many (rings)
/// @param vectors  which change nothing but the time
/// Cost O(points + rings). Thread-safe. Deterministic.
Result<PlannedTuft> plan_tuft(const Tuft& tuft, const Head& head, const MeshDetail& detail, const Limits& limits,
                              Vectors vectors = widest_vectors());

/// The same for a tuft that check_tuft() finds nothing wrong with. @errors  too_many (rings)
Result<PlannedTuft> plan_sound_tuft(const Tuft& tuft, const Head& head, const MeshDetail& detail, const Limits& limits,
                                    Vectors vectors = widest_vectors());

/// Where a tuft's vertices go. Each span holds vertex_count() times its width; triangles are counter-clockwise from
/// outside.
struct MeshSpans {
    std::span<float> positions;       ///< 3 per vertex, metres
    std::span<float> normals;         ///< 3 per vertex, unit, outward
    std::span<float> uvs;             ///< 2 per vertex: u around 0..1, v along the arc length 0..1
    std::span<std::uint16_t> joints;  ///< 4 per vertex: bones of the chain, plus first_joint; or empty
    std::span<float> weights;         ///< 4 per vertex, sum 1; or empty
    std::uint16_t first_joint = 0;
};

/// Writes a planned tuft's vertices: closed, outward, finite.
/// Cost O(vertices). Thread-safe for disjoint spans. Deterministic.
void write_vertices(const MeshPlan& plan, const MeshSpans& out, Vectors vectors = widest_vectors());

/// Writes a planned tuft's triangles. @param first_vertex  added to every index
void write_indices(const MeshPlan& plan, std::span<std::uint16_t> out, std::uint32_t first_vertex = 0);
void write_indices(const MeshPlan& plan, std::span<std::uint32_t> out, std::uint32_t first_vertex = 0);

/// A closed triangle mesh with its skin.
struct Mesh {
    std::vector<float> positions, normals, uvs, weights;
    std::vector<std::uint16_t> joints;
    std::vector<std::uint32_t> indices;
};

/// A planned tuft as a mesh of its own.
Mesh to_mesh(const MeshPlan& plan, Vectors vectors = widest_vectors());

}  // namespace tuftwave
